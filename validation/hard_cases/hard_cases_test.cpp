// SPDX-License-Identifier: MIT
// Every hard case through every technique of the registry: certified answers are the definition's, whatever the insertion order and subgroup width;
// conservative ones differ only where the sign itself is fp32 noise; published ones are seen to fail where they are known to. The latter two, and
// more than one insertion order, at subgroup width 8 only, unless GNOMON_LONG is set (validation/long_run.sh).
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <ostream>

#include "validation/hard_cases/runner.hpp"

namespace gno::hard {

void PrintTo(const HardCase& hardCase, std::ostream* out);  // found by GoogleTest
void PrintTo(const HardCase& hardCase, std::ostream* out) { *out << hardCase.name; }

namespace {

class HardCases : public testing::TestWithParam<HardCase> {};

std::string suiteName(const testing::TestParamInfo<HardCase>& info) {
    std::string name;
    bool upper = true;
    for (const char c : info.param.name) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0) name += upper ? char(std::toupper(c)) : c;
        upper = std::isalnum(static_cast<unsigned char>(c)) == 0;
    }
    return name;
}

TEST_P(HardCases, HoldsItsPromises) {
    const HardCase& hardCase = GetParam();
    const bool whole = test::passes().device().facts().subgroupSize == 8 || std::getenv("GNOMON_LONG");
    const uint32_t seeds = std::getenv("GNOMON_LONG") ? 8 : whole ? 4 : 1;
    const CaseResult result = runCase(hardCase, {.insertionSeeds = seeds, .counters = false, .certifiedOnly = !whole});

    EXPECT_TRUE(result.oracleWrong.empty()) << "the oracle differs from brute force: " << result.oracleWrong;
    EXPECT_GT(result.samples, 0u);
    bool certified = false;
    for (const Tally& tally : result.tallies) {
        SCOPED_TRACE(hardCase.name + ": " + hardCase.why);
        if (tally.precision == host::Precision::certified) {
            certified = true;
            EXPECT_EQ(tally.refused, "") << tally.technique;
            EXPECT_GT(tally.runs, 0u) << tally.technique;
            EXPECT_EQ(tally.wrong, 0u) << tally.leaks << " leaks, " << tally.falseDark << " false dark of " << tally.answers
                                       << "; first: " << tally.firstWrong;
        } else if (tally.precision == host::Precision::conservative) {
            EXPECT_LE(double(tally.wrong), hardCase.conservativeLimit * double(tally.answers))
                << tally.wrong << " of " << tally.answers << "; first: " << tally.firstWrong;
        } else if (hardCase.expectsPublishedErrors && tally.technique.ends_with("psv")) {
            EXPECT_GT(tally.wrong, 0u) << tally.technique << ": this case is here because the algorithm as published fails on it";
        }
    }
    EXPECT_TRUE(certified) << "no technique has the certified rung";
}

INSTANTIATE_TEST_SUITE_P(All, HardCases, testing::ValuesIn(hardCases()), suiteName);

TEST(HardCaseList, NamesAreUniqueAndSaid) {
    std::vector<std::string> names;
    for (const HardCase& hardCase : hardCases()) {
        names.push_back(hardCase.name);
        EXPECT_FALSE(hardCase.why.empty()) << hardCase.name;
        EXPECT_GT(hardCase.scenes, 0u);
    }
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
    EXPECT_GE(std::count_if(hardCases().begin(), hardCases().end(), [](const HardCase& c) { return c.expectsPublishedErrors; }), 3);
}

}  // namespace
}  // namespace gno::hard
