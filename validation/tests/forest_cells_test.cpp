// SPDX-License-Identifier: MIT
// glsl/forest as text on the CPU, in every rounding mode that a device may have: what cells.glsl claims of cells and casters, against exact
// arithmetic; whole forests, against the definition. That these checks can fail is what validation/mutants shows.
#include <gtest/gtest.h>

#include <cstdlib>

#include "host_min/techniques/cell_assignment.hpp"
#include "validation/mutants/forest_cases.hpp"

namespace gno::mutants {
namespace {

std::unique_ptr<cpu::Forest> plain() {
    EXPECT_EQ(cpu::forestVariants().size(), 1u);
    return cpu::forestVariants().at(0).make();
}

/// More by GNOMON_FOREST_QUESTIONS, for a long run.
uint questionCount() {
    const char* given = std::getenv("GNOMON_FOREST_QUESTIONS");
    return given ? uint(std::atoi(given)) : 1500u;
}

TEST(ForestCells, ClaimsHold) {
    const auto forest = plain();
    cpu::CellTally all;
    for (const CellFamily& family : makeCellFamilies(questionCount())) {
        cpu::CellTally tally;
        EXPECT_EQ(failure(family, *forest, tally), "");
        std::printf("%-30s %8llu points, %8llu shadowed (%llu alone), cells missed %llu, covered %llu\n", family.name.c_str(),
                    (unsigned long long)tally.points, (unsigned long long)tally.shadowed, (unsigned long long)tally.alone,
                    (unsigned long long)tally.missed, (unsigned long long)tally.covered);
        all += tally;
    }
    EXPECT_GT(all.shadowed, all.points / 20);
    EXPECT_GT(all.alone, 1000u);
    EXPECT_GT(all.missed, 1000u);
    EXPECT_GT(all.covered, 1000u);
}

TEST(Forests, AnswerByTheDefinition) {
    const auto forest = plain();
    for (const ForestCase& c : makeForestCases(60)) EXPECT_EQ(failure(c, *forest), "");
}

/// Three walls before a light in the middle of a grid of 2 x 2 cells: what is counted is known.
struct Walls {
    cpu::TinyScene scene{
        vec4(0, 0, 0, 1),
        {{vec3(-0.25f, -0.25f, 0.125f), vec3(0.25f, -0.25f, 0.125f), vec3(0, 0.25f, 0.125f)},
         {vec3(-0.75f, -0.75f, 0.5f), vec3(0.75f, -0.75f, 0.5f), vec3(0, 0.75f, 0.5f)},
         {vec3(0.5f, 0.5f, 1), vec3(0.75f, 0.5f, 1), vec3(0.5f, 0.75f, 1)}},
        {{vec3(0.0625f, 0.0625f, 0.25f), GNO_NO_CASTER}, {vec3(0, 0, 0.75f), GNO_NO_CASTER}, {vec3(0.5f, 0.5f, 0.75f), GNO_NO_CASTER}}};
    GnoForestGrid grid = host::forestGrid(scene.light, vec3(-1), vec3(1), 2);
};

TEST(Forests, APoolTooSmallTells) {
    const auto forest = plain();
    Walls walls;
    const auto build = [&](uint capacity) {
        forest->build(walls.scene.casters, walls.scene.light, walls.grid, walls.scene.samples,
                      {.viewCull = false, .cover = false, .capacity = capacity});
    };
    build(0xFFFFFFFFu);
    const uint needed = forest->header().pairs;
    ASSERT_GT(needed, 3u);
    EXPECT_EQ(forest->pairs().size(), needed);
    for (uint capacity = 0; capacity < needed; ++capacity) {
        ASSERT_NO_THROW(build(capacity)) << "no array is left";
        EXPECT_EQ(forest->header().pairs, needed) << "of " << capacity;
        EXPECT_EQ(forest->pairs().size(), capacity);
        for (const GnoForestPair& pair : forest->pairs()) EXPECT_LT(pair.caster, 3u) << "of " << capacity;
        EXPECT_EQ(forest->header().groupsOfPairs, 1u) << "one at least: it writes the header of the trees";
        for (const GnoViewSample& sample : walls.scene.samples)
            EXPECT_EQ(forest->ask(cpu::TopQuery::dHybrid, sample).visibility, GNO_VISIBILITY_UNKNOWN) << "of " << capacity;
    }
}

TEST(Forests, WithoutCastersOrSamples) {
    const auto forest = plain();
    Walls walls;
    forest->build({}, walls.scene.light, walls.grid, walls.scene.samples, {});
    EXPECT_EQ(forest->header().pairs, 0u);
    for (const GnoViewSample& sample : walls.scene.samples) EXPECT_FALSE(forest->ask(cpu::TopQuery::dHybrid, sample).inShadow);
    forest->build(walls.scene.casters, walls.scene.light, walls.grid, {}, {});
    EXPECT_EQ(forest->header().pairs, 0u) << "with view culling nobody needs a caster";
    forest->build(walls.scene.casters, walls.scene.light, walls.grid, {}, {.viewCull = false});
    EXPECT_GT(forest->header().pairs, 0u);
    for (const GnoViewSample& sample : walls.scene.samples)
        EXPECT_TRUE(forest->ask(cpu::TopQuery::dHybrid, sample).inShadow) << "built without the view, good for any";
}

}  // namespace
}  // namespace gno::mutants
