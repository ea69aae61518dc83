// SPDX-License-Identifier: MIT
// Technique light-grid: whatever the cells and the nesting, the masks are the oracle's; its lists are complete and in order; pools that are too
// small are enlarged, or, when they were given, nothing is answered.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <set>

#include "glsl/rivals/light_grid.h"
#include "glsl/rivals/light_grid_passes.hpp"
#include "host_min/error.hpp"
#include "validation/tests/made_scenes.hpp"

namespace gno {
namespace {

using host::Precision;
using host::cases::HardCase;
using host::cases::Random;
using host::cases::snap;
using Strings = std::vector<std::string>;

constexpr uint32_t kSeed = 2015;

uint64_t number(const host::NamedNumbers& list, const std::string& name) {
    for (const auto& [key, value] : list)
        if (key == name) return value;
    throw std::out_of_range(name);
}

/// Without counters only the timed shaders run (and are compiled).
host::TechniqueResult run(const test::Scene& scene, const Strings& settings, Precision precision = Precision::certified, bool counters = false) {
    const host::Frame frame = test::frameOf(scene);
    host::FrameInputs inputs(test::passes(), frame, scene.samples);
    inputs.setLight(scene.light, scene.cull);
    host::StructureCache structures;
    host::Technique& technique = host::techniqueByName("light-grid");
    auto result = technique.run(inputs, structures, host::Settings(technique.info().settings, settings),
                                {.precision = precision, .counters = counters, .dump = true, .warmUp = false});
    result.visibility.resize(scene.samples.size());  // the last row may be longer
    return result;
}

std::string complaint(const test::Scene& scene, const Strings& settings) {
    try {
        run(scene, settings);
    } catch (const host::InputError& error) {
        return error.what();
    }
    return "";
}

void expectTheOracles(const test::Scene& scene, const std::vector<Strings>& all, const std::vector<Precision>& rungs = {Precision::certified}) {
    const host::OracleAnswer want = test::ask(scene);
    for (const Strings& settings : all) {
        for (const Precision precision : rungs) {
            const test::Wrong wrong = test::compare(run(scene, settings, precision), want);
            EXPECT_EQ(wrong.wrong, 0u) << name(precision) << " with " << testing::PrintToString(settings) << ", leaks " << wrong.leaks
                                       << ", first wrong: sample " << wrong.first << " (seed " << kSeed << ")";
        }
    }
}

template <class T>
std::vector<T> dumped(const host::TechniqueResult& result, const std::string& name) {
    for (const host::DumpedBuffer& buffer : result.dump) {
        if (buffer.name != name) continue;
        std::vector<T> records(buffer.bytes.size() / sizeof(T));
        std::memcpy(records.data(), buffer.bytes.data(), records.size() * sizeof(T));
        return records;
    }
    throw std::out_of_range(name);
}

/// Every list in order and without a caster twice, each item in one list. The length of the longest.
size_t expectLists(const host::TechniqueResult& result) {
    const auto lists = dumped<GnoLightGridList>(result, "lists");
    const auto items = dumped<GnoLightGridItem>(result, "items");
    std::vector<uint8_t> taken(items.size(), 0);
    size_t longest = 0, total = 0, nested = 0;
    for (const GnoLightGridList& list : lists) {
        if (list.end == GNO_LIGHT_GRID_NESTED) {
            ++nested;
            continue;
        }
        longest = std::max<size_t>(longest, list.end - list.first);
        total += list.end - list.first;
        std::set<uint32_t> casters;
        for (uint32_t i = list.first; i < list.end; ++i) {
            EXPECT_EQ(taken.at(i)++, 0) << "item " << i;
            EXPECT_TRUE(casters.insert(items[i].caster).second) << "caster " << items[i].caster << " is in a list twice";
            if (i == list.first) continue;
            const auto key = [&](uint32_t at) { return std::pair(items[at].depth, items[at].caster); };
            EXPECT_LT(key(i - 1), key(i)) << "item " << i;
        }
    }
    EXPECT_EQ(total, number(result.counters.more, "items"));
    EXPECT_EQ(nested, number(result.counters.more, "nested_cells"));
    return longest;
}

TEST(LightGrid, OneMaskWhateverTheCells) {
    for (const bool directional : {false, true}) {
        const test::Scene scene = test::soup(kSeed, directional, 400, 0.3, 3000);
        expectTheOracles(
            scene, {{}, {"cells=1", "nest=0"}, {"cells=1", "nest=1"}, {"cells=4"}, {"cells=16", "nest=1", "caster_planes=computed"}, {"cells=256"}},
            {Precision::conservative, Precision::certified});
    }
}

TEST(LightGrid, ListsThatOutliveTheView) {
    for (const bool directional : {false, true})
        expectTheOracles(test::soup(kSeed, directional, 400, 0.3, 3000), {{"view_cull=off", "cover=off", "cells=16"}});
}

TEST(LightGrid, BothStagesGiveOneMask) {
    if (test::passes().device().facts().subgroupSize > 8)
        GTEST_SKIP() << "lavapipe 25.0 with LLVM 15 crashes when it compiles a graphics pipeline for width 16";
    const test::Scene scene = test::soup(kSeed, false, 400, 0.3, 3000);
    for (const char* planes : {"caster_planes=stored", "caster_planes=computed"})
        EXPECT_EQ(run(scene, {"stage=fragment", planes}).visibility, run(scene, {planes}).visibility);
}

// Samples on and next to planes, edges, vertices: only the definition knows, and the certified rung.
TEST(LightGrid, HardCases) {
    for (const HardCase& hard : host::cases::hardCases(kSeed, 320)) {
        if (!hard.isCaster.empty()) continue;
        SCOPED_TRACE(hard.name);
        test::Scene scene{hard.triangles, {}, hard.light, hard.samples, host::Cull::none};
        test::keepTheContract(scene);
        expectTheOracles(scene, {{"cells=1", "nest=0"}, {"cells=4", "nest=1"}, {"cells=64", "nest=1", "caster_planes=computed"}});
    }
}

/// Casters whose edges lie in the border planes of cells and sub cells, samples in those planes and a unit of the grid beside them.
TEST(LightGrid, BordersOfSubCells) {
    for (const bool directional : {false, true}) {
        Random random(kSeed);
        test::Scene scene;
        scene.light = directional ? glm::vec4(0, 0, 1, 0) : glm::vec4(0, 0, 0.5f, 1);
        const auto border = [&] { return float(int(random.below(33)) - 16) / 16.0f; };  // of 32 sub cells along a face
        scene.triangles = {{{-1, -1, 0}, {-0.9375f, -1, 0}, {-1, -0.9375f, 0}},
                           {{1, 1, 0}, {0.9375f, 1, 0}, {1, 0.9375f, 0}}};  // the grid spans [-1, 1]
        const auto onBorder = [&](float x, float y, float z) {              // x / |z - 0.5| is a border's for a point light
            return directional ? glm::vec3(x, y, z) : glm::vec3(x * (0.5f - z), y * (0.5f - z), z);
        };
        for (int i = 0; i < 150; ++i) {
            const float x = border(), y = border(), z = float(int(random.below(8))) / 32.0f;
            const float side = x > 0 ? -0.0625f : 0.0625f, up = y > 0 ? -0.125f : 0.125f;
            scene.triangles.push_back({onBorder(x, y, z), onBorder(x + side, y, z), onBorder(x, y + up, z)});
        }
        while (scene.samples.size() < 2000) {
            glm::vec3 p = onBorder(border(), border(), -float(random.below(16)) / 32.0f);
            if (random.below(2)) p = host::cases::neighbour(p, random);
            if (host::cases::inCube(p)) scene.samples.push_back({p, host::kNoCaster});
        }
        expectTheOracles(scene, {{"cells=4", "nest=1"}, {"cells=4", "nest=0"}, {"cells=32", "nest=0"}});
        EXPECT_GT(number(run(scene, {"cells=4", "nest=1"}).counters.more, "nested_cells"), 3u);
    }
}

TEST(LightGrid, ListsAreCompleteAndInOrder) {
    for (const bool directional : {false, true}) {
        const test::Scene scene = test::soup(kSeed, directional, 3000, 0.1, 2000);
        EXPECT_GT(expectLists(run(scene, {"cells=1", "nest=0"})), 512u);  // blocks and merges
        EXPECT_LT(expectLists(run(scene, {"cells=4", "nest=1"})), 512u);
    }
}

/// One list of 1500 casters that all begin at the same depth: the order is the casters' numbers.
TEST(LightGrid, EqualDepths) {
    test::Scene scene;
    scene.light = {0, 1, 0, 0};
    for (int i = 0; i < 1500; ++i) {
        const float x = float(i % 50 - 25) / 32.0f, z = float(i / 50 - 15) / 32.0f;
        scene.triangles.push_back({{x, 0.25f, z}, {x + 0.03125f, 0.25f, z}, {x, 0.25f, z + 0.03125f}});
    }
    Random random(kSeed);
    while (scene.samples.size() < 1000) scene.samples.push_back({snap(random.inCube()), host::kNoCaster});
    const auto result = run(scene, {"cells=1", "nest=0", "view_cull=off"});
    EXPECT_EQ(expectLists(result), 1500u);
    EXPECT_EQ(test::compare(result, test::ask(scene)).wrong, 0u);
    std::set<uint32_t> depths;
    for (const GnoLightGridItem& item : dumped<GnoLightGridItem>(result, "items")) depths.insert(item.depth);
    EXPECT_EQ(depths.size(), 1u);
}

TEST(LightGrid, NoCasters) {
    for (const bool directional : {false, true}) {
        const test::Scene scene = test::soup(kSeed, directional, 0, 1, 100);
        const auto result = run(scene, {}, Precision::certified, true);
        EXPECT_EQ(result.visibility, std::vector<uint32_t>(100, GNO_VISIBILITY_LIT));
        EXPECT_EQ(number(result.counters.more, "items"), 0u);
        EXPECT_EQ(result.counters.visitedNodes, 0u);
    }
}

TEST(LightGrid, Pools) {
    const test::Scene scene = test::soup(kSeed, false, 400, 0.3, 1000);
    const host::OracleAnswer want = test::ask(scene);
    for (const Strings& cells : {Strings{"cells=4", "nest=1"}, Strings{"cells=1", "nest=0"}}) {
        const auto free = run(scene, cells);
        const uint64_t most = std::max(number(free.counters.more, "pairs"), number(free.counters.more, "items"));
        const auto with = [&](uint64_t pool) {
            Strings settings = cells;
            settings.push_back("pool=" + std::to_string(pool));
            return settings;
        };
        const auto exactly = run(scene, with(most));
        EXPECT_EQ(test::compare(exactly, want).wrong, 0u);
        expectLists(exactly);
        const std::string text = complaint(scene, with(most - 1));
        EXPECT_NE(text.find("pool=" + std::to_string(most - 1)), std::string::npos) << text;
        EXPECT_NE(text.find(std::to_string(most)), std::string::npos) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    }
}

/// The worst sample is in the pixels' counts: what they add up to is what is told of all, and nesting shortens it.
TEST(LightGrid, CountsPerSample) {
    const test::Scene scene = test::soup(kSeed, false, 3000, 0.1, 2000);
    std::vector<uint32_t> worst;
    for (const Strings& settings : {Strings{"cells=1", "nest=0"}, Strings{"cells=4", "nest=0"}, Strings{"cells=4", "nest=1"}}) {
        const auto result = run(scene, settings, Precision::certified, true);
        EXPECT_EQ(std::accumulate(result.visitedNodes.begin(), result.visitedNodes.end(), uint64_t(0)), result.counters.visitedNodes);
        worst.push_back(*std::max_element(result.visitedNodes.begin(), result.visitedNodes.end()));
    }
    EXPECT_GT(worst[0], worst[1]);
    EXPECT_GT(worst[1], worst[2]);
    EXPECT_GT(worst[2], 0u);
}

TEST(LightGrid, PassesAndBytes) {
    const auto result = run(test::soup(kSeed, false, 400, 0.3, 3000), {"pool=8000"});
    for (const host::RecordPass& pass : result.passes) EXPECT_EQ(host::isBuildPass(pass.name), pass.name != "light_grid_query") << pass.name;
    EXPECT_EQ(result.hostWaits, 0u);
    EXPECT_EQ(number(result.bytes, "planes"), 400u * 64u);
    EXPECT_EQ(number(result.bytes, "items"), 8 * 8000u);
    EXPECT_EQ(number(result.bytes, "pairs"), 8 * 8000u);
    EXPECT_EQ(number(result.bytes, "lists"), 8 * (6u * 64 * 64 + 64 * (8000 / 9))) << "room for all cells that 8000 pairs can make crowded";
}

/// Pools are chosen before anything is counted; they are enlarged when they were too small, and the next frame knows.
TEST(LightGrid, PoolsThatWereTooSmallAreEnlarged) {
    const test::Scene scene = test::soup(kSeed, false, 300, 0.6, 1000);
    const host::Frame frame = test::frameOf(scene);
    host::FrameInputs inputs(test::passes(), frame, scene.samples);
    inputs.setLight(scene.light, scene.cull);
    host::StructureCache structures;
    host::Technique& technique = host::techniqueByName("light-grid");
    const auto ask = [&] {
        structures.nextFrame();
        return technique.run(inputs, structures, host::Settings(technique.info().settings, Strings{"cells=64", "view_cull=off", "cover=off"}),
                             {.counters = false, .dump = true, .warmUp = false});
    };
    auto first = ask();
    const LightGridPools pools = lightGridFirstPools(inputs.casterCount());
    ASSERT_GT(number(first.counters.more, "pairs"), pools.pairs) << "the scene has to be too much";
    ASSERT_GT(number(first.counters.more, "items"), pools.items);
    EXPECT_GE(first.reruns, 1u);
    EXPECT_EQ(number(first.counters.more, "crowded_cells"), 0u);
    expectLists(first);
    const auto next = ask();
    EXPECT_EQ(next.reruns, 0u);
    EXPECT_EQ(next.visibility, first.visibility);
    first.visibility.resize(scene.samples.size());
    EXPECT_EQ(test::compare(first, test::ask(scene)).wrong, 0u);
}

/// Where one binding has no room for all sub cells, a cell stays one list: longer, and right.
TEST(LightGrid, RoomForSubCellsIsWhatABindingHolds) {
    const LightCells cells{.casters = 1000, .resolution = 64, .faces = 6};
    EXPECT_EQ(lightGridNests(cells, 9000, 0, 1u << 27), 0u);
    EXPECT_EQ(lightGridNests(cells, 9000, 8, 1u << 27), 1000u);
    EXPECT_EQ(lightGridNests(cells, 1u << 30, 8, 1u << 27), 24576u) << "no more than there are cells";
    const uint64_t few = lightGridNests(cells, 1u << 30, 8, 1u << 20);
    EXPECT_EQ(few, ((1u << 20) / 8 - 24576) / 64);
    EXPECT_LE(8 * gnoLightGridLists(24576, uint32_t(few)), 1u << 20);
    EXPECT_EQ(lightGridNests(cells, 1u << 30, 8, 1u << 10), 0u);
}

}  // namespace
}  // namespace gno
