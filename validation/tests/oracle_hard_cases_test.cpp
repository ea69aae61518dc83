// SPDX-License-Identifier: MIT
// The fast oracle against brute force on every family of hard case, and the proof that these cases see a definition that is slightly off.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "validation/oracle/definition.hpp"
#include "validation/tests/oracle_cases.hpp"

namespace {

using namespace gno::host;
using namespace gno::host::oracle;

class Seeded : public testing::TestWithParam<uint32_t> {};

TEST_P(Seeded, OracleEqualsBruteForce) {
    size_t shadowed = 0, self = 0;
    for (const cases::HardCase& c : cases::hardCases(GetParam(), 1200)) {
        const OracleAnswer want = bruteForce(c.question()), got = makeOracle()->ask(c.question(), {});
        ASSERT_EQ(got.inShadow.size(), c.samples.size());
        ASSERT_EQ(got.caster.size(), c.samples.size());
        for (size_t i = 0; i < c.samples.size(); ++i) {
            ASSERT_EQ(got.inShadow[i], want.inShadow[i]) << c.name << ", sample " << i << ", want caster " << want.caster[i];
            const uint32_t named = got.caster[i];
            ASSERT_EQ(named == kNoCaster, got.inShadow[i] == 0) << c.name << ", sample " << i;
            if (named == kNoCaster) continue;
            ASSERT_LT(named, c.triangles.size());
            ASSERT_NE(named, c.samples[i].own) << c.name;
            ASSERT_TRUE(c.isCaster.empty() || c.isCaster[named] != 0) << c.name;
            ASSERT_TRUE(inShadowOf(c.triangles[named], c.light, c.samples[i].position)) << c.name;
        }
        EXPECT_EQ(got.selfShadowed, want.selfShadowed) << c.name;
        shadowed += size_t(std::count(got.inShadow.begin(), got.inShadow.end(), uint8_t(1)));
        self += got.selfShadowed;
    }
    EXPECT_GT(shadowed, 5000u);
    EXPECT_GT(self, 100u);
}

INSTANTIATE_TEST_SUITE_P(FourSeeds, Seeded, testing::Values(1u, 2u, 3u, 4u));

// Samples that a changed definition answers differently, per family.
std::map<std::string, size_t> differences(bool (*changed)(const VolumeSigns&)) {
    std::map<std::string, size_t> out;
    for (const cases::HardCase& c : cases::hardCases(1, 1200)) {
        const OracleAnswer right = makeOracle()->ask(c.question(), {});
        size_t& count = out[c.name];
        for (size_t i = 0; i < c.samples.size(); ++i) {
            bool shadow = false;
            for (uint32_t t = 0; t < c.triangles.size() && !shadow; ++t) {
                shadow = t != c.samples[i].own && (c.isCaster.empty() || c.isCaster[t] != 0) &&
                         changed(volumeSigns(c.triangles[t], c.light, c.samples[i].position));
            }
            count += shadow != (right.inShadow[i] != 0);
        }
    }
    return out;
}

bool allSides(const VolumeSigns& s, bool (*ok)(int side, int inside)) {
    return std::all_of(s.side.begin(), s.side.end(), [&](int side) { return ok(side, s.inside); });
}
bool closedSide(int side, int inside) { return side == 0 || side == inside; }

TEST(Mutants, TheUnchangedDefinitionHasNoDifference) {
    for (const auto& [name, count] : differences(inShadow)) EXPECT_EQ(count, 0u) << name;
}

TEST(Mutants, AnOpenConeIsSeen) {
    auto found = differences([](const VolumeSigns& s) {
        return s.facing != 0 && s.cap == -s.facing && allSides(s, [](int side, int inside) { return side == inside; });
    });
    EXPECT_GT(found["shared edges, point light over a vertex"], 0u);
    EXPECT_GT(found["shared edges, light from above"], 0u);
    EXPECT_GT(found["lattice cubes, lattice light"], 0u);
    EXPECT_GT(found["lattice cubes, light along an axis"], 0u);
    EXPECT_GT(found["lattice soup, point light"], 0u);
    EXPECT_GT(found["one caster"], 0u);
    EXPECT_GT(found["one caster, direction"], 0u);
}

TEST(Mutants, ANonStrictCapIsSeen) {
    auto found = differences([](const VolumeSigns& s) { return s.facing != 0 && s.cap != s.facing && allSides(s, closedSide); });
    EXPECT_GT(found["shared edges, point light over a vertex"], 0u);
    EXPECT_GT(found["lattice cubes, slanted lattice direction"], 0u);
    EXPECT_GT(found["lattice soup, point light"], 0u);
    EXPECT_GT(found["one caster"], 0u);
    EXPECT_GT(found["light inside a closed room"], 0u);
}

TEST(Mutants, CastersThatAreEdgeOnAreSeen) {
    auto found = differences([](const VolumeSigns& s) { return (s.facing == 0 || s.cap == -s.facing) && allSides(s, closedSide); });
    EXPECT_GT(found["light in the plane of casters"], 0u);
    EXPECT_GT(found["direction in the plane of casters"], 0u);
}

TEST(Mutants, AForgottenCapIsSeen) {
    auto found = differences([](const VolumeSigns& s) { return s.facing != 0 && allSides(s, closedSide); });
    EXPECT_GT(found["lattice cubes, light along an axis"], 0u);
    EXPECT_GT(found["one caster"], 0u);
    EXPECT_GT(found["soup, point light"], 0u);
}

}  // namespace
