// SPDX-License-Identifier: MIT
// A plan covers exactly its sweep's jobs; GNU parallel runs it; merge gives what one sweep would.
#include <gtest/gtest.h>

#include "validation/tests/study_child.hpp"

namespace gno::test {
namespace {

namespace fs = std::filesystem;
using study::Row;

const char* const kSweep =
    "room:12 --vary-scene fuzzy=4000,5000 --size 16x9,24x14 --technique psv,d-hybrid --precision published,certified --vary stack=4 --repeat 2";

class Plan : public Study {
protected:
    [[nodiscard]] std::multiset<std::string> jobsOf(const std::vector<std::string>& arguments) const {
        std::vector<std::string> all = arguments;
        all.push_back("--list");
        const Outcome outcome = stage.run(all);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        const auto lines = linesOf(outcome.out);
        return {lines.begin(), lines.end()};
    }
    [[nodiscard]] std::vector<std::string> plan(const std::string& what) const {
        const Outcome outcome = stage.run(words("plan " + what + " --into " + (stage.path() / "jobs").string()));
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return linesOf(outcome.out);
    }
};

TEST_F(Plan, CoversExactlyTheSweepsJobs) {
    const auto lines = plan(std::string("sweep ") + kSweep);
    EXPECT_EQ(lines.size(), 6u) << "one line a group";
    std::multiset<std::string> planned;
    std::set<std::string> files;
    for (const std::string& line : lines) {
        auto parts = words(line);
        EXPECT_EQ(parts[0], GNOMON_PROGRAM);
        EXPECT_TRUE(files.insert(parts.back()).second) << "two jobs, one file: " << line;
        parts.erase(parts.begin());
        planned.merge(jobsOf(parts));
    }
    auto wanted = words(std::string("sweep ") + kSweep + " --results " + results.string());
    EXPECT_EQ(planned, jobsOf(wanted));
    EXPECT_EQ(planned.size(), 6u * 8u);
}

TEST_F(Plan, IsTheSameForTheSameSweep) { EXPECT_EQ(plan("short --tiny"), plan("short --tiny")); }

TEST_F(Plan, GnuParallelRunsItAndMergeJoinsIt) {
    const std::string small = "--vary-scene fuzzy=4000,5000 --size 16x9 --technique psv,d-hybrid --precision published,certified --repeat 2";
    const auto lines = plan("sweep " + small);
    ASSERT_EQ(lines.size(), 2u);
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    const std::string file = stage.write("plan.txt", text), log = (stage.path() / "parallel.log").string();
    ASSERT_EQ(std::system(("'" GNOMON_PARALLEL "' --will-cite --jobs 2 < '" + file + "' > '" + log + "' 2>&1").c_str()), 0) << readFile(log);
    std::vector<std::string> merge{"merge"};
    for (const auto& entry : fs::directory_iterator(stage.path() / "jobs"))
        if (entry.path().extension() == ".jsonl") merge.push_back(entry.path().string());
    EXPECT_EQ(merge.size(), 3u);
    merge.insert(merge.end(), {"--into", results.string()});
    const Outcome merged = stage.run(merge);
    ASSERT_EQ(merged.code, 0) << merged.err;
    EXPECT_EQ(merged.err, "");
    const Outcome rest = sweep(small);
    EXPECT_EQ(rest.code, 0) << rest.err;
    EXPECT_NE(rest.out.find("0 rows of 0 groups added"), std::string::npos) << "something was missing: " << rest.out;
    EXPECT_EQ(rows().size(), 8u);
    for (const Row& row : rows()) {
        if (!row.contains("pictures")) continue;
        for (const auto& [key, name] : row["pictures"].items()) EXPECT_TRUE(fs::exists(stage.out() / name.get<std::string>())) << name;
    }
}

}  // namespace
}  // namespace gno::test
