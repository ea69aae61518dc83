// SPDX-License-Identifier: MIT
// The forest on the device: whatever its cells, culling, query and stack, the mask is the definition's; a pool that is too small is enlarged, or,
// when it was given, nothing is answered; without cells=counted the host does not wait.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>

#include "glsl/forest/cells.h"
#include "glsl/forest/passes.hpp"
#include "host_min/error.hpp"
#include "validation/support/device_test.hpp"
#include "validation/tests/oracle_cases.hpp"

namespace gno {
namespace {

using host::Precision;
using host::cases::Random;
using Strings = std::vector<std::string>;

constexpr uint32_t kSeed = 6464;

/// Casters of all sizes before and behind samples that are on no caster.
test::Scene soup(bool directional) {
    Random random(kSeed);
    test::Scene scene;
    scene.light = directional ? glm::vec4(0.375f, 1, 0.25f, 0) : glm::vec4(0.125f, 0.5f, -0.25f, 1);
    for (int i = 0; i < 300; ++i) {
        const double size = i < 8 ? 0.9 : 0.15;
        const glm::dvec3 at = random.inCube(1 - size);
        const auto corner = [&] { return host::cases::snap(at + random.inCube(size)); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        scene.triangles.push_back({a, b, c});
    }
    while (scene.samples.size() < 2048) scene.samples.push_back({host::cases::snap(random.inCube()), host::kNoCaster});
    return scene;
}

/// One scene on the device, asked many times.
class Asked {
public:
    explicit Asked(test::Scene scene)
        : scene_(std::move(scene)), frame_(test::frameOf(scene_)), inputs_(test::passes(), frame_, scene_.samples, scene_.width) {
        inputs_.setLight(scene_.light, scene_.cull);
        want_ = host::makeOracle()->ask({scene_.triangles, test::castersOf(scene_), scene_.light, scene_.samples}, [](double) {});
    }
    host::TechniqueResult run(const Strings& settings, bool dump = false) {
        host::Technique& technique = host::techniqueByName("forest");
        return technique.run(inputs_, structures_, host::Settings(technique.info().settings, settings),
                             {.precision = Precision::certified, .counters = dump, .dump = dump, .warmUp = false});
    }
    void expectRight(const Strings& settings) {
        host::TechniqueResult result = run(settings);
        result.visibility.resize(scene_.samples.size());
        const test::Wrong wrong = test::compare(result, want_, scene_.samples);
        EXPECT_EQ(wrong.wrong, 0u) << testing::PrintToString(settings) << ", leaks " << wrong.leaks << ", first wrong: sample " << wrong.first;
    }
    void nextFrame() { structures_.nextFrame(); }
    [[nodiscard]] const test::Scene& scene() const { return scene_; }
    [[nodiscard]] const host::FrameInputs& inputs() const { return inputs_; }
    [[nodiscard]] const host::OracleAnswer& want() const { return want_; }

private:
    test::Scene scene_;
    host::Frame frame_;
    host::FrameInputs inputs_;
    host::StructureCache structures_;
    host::OracleAnswer want_;
};

uint64_t numberOf(const host::TechniqueResult& result, const std::string& name) {
    for (const auto& [key, value] : result.counters.more)
        if (key == name) return value;
    throw std::runtime_error("the forest does not count " + name);
}

template <class T>
std::vector<T> dumped(const host::TechniqueResult& result, const std::string& name) {
    for (const host::DumpedBuffer& buffer : result.dump) {
        if (buffer.name != name) continue;
        std::vector<T> values(buffer.bytes.size() / sizeof(T));
        std::memcpy(values.data(), buffer.bytes.data(), values.size() * sizeof(T));
        return values;
    }
    throw std::runtime_error("no buffer is called " + name);
}

/// The pool holds each pair of the cells' counts once, in their cells' ranges.
void expectWhole(const host::TechniqueResult& result, uint64_t casters) {
    const auto header = dumped<GnoForestHeader>(result, "forest_header").at(0);
    auto pairs = dumped<GnoForestPair>(result, "pairs");
    const auto cells = dumped<GnoForestCell>(result, "cells");
    ASSERT_GE(pairs.size(), header.pairs);
    EXPECT_EQ(numberOf(result, "pairs"), header.pairs);
    pairs.resize(header.pairs);
    std::set<std::pair<uint, uint>> seen;
    for (const GnoForestPair& pair : pairs) {
        ASSERT_LT(pair.caster, casters);
        ASSERT_LT(pair.cell, cells.size());
        EXPECT_TRUE(seen.insert({pair.caster, pair.cell}).second) << "caster " << pair.caster << " is twice in cell " << pair.cell;
        EXPECT_NE(cells[pair.cell].root, GNO_FOREST_NONE);
    }
}

std::string refusal(Asked& asked, const Strings& settings) {
    try {
        (void)asked.run(settings);
    } catch (const host::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(ForestTechnique, OneMaskWhateverTheSettings) {
    for (const bool directional : {false, true}) {
        Asked asked(soup(directional));
        for (const char* cells : {"cells=1", "cells=8", "cells=256"})
            for (const char* cull : {"view_cull=on", "view_cull=off"})
                for (const char* cover : {"cover=on", "cover=off"}) asked.expectRight({cells, cull, cover});
        for (const Strings& query : {Strings{"query=stack"}, Strings{"query=stack", "stack=1"}, Strings{"query=stackless"},
                                     Strings{"query=hybrid", "stack=1"}, Strings{"seed=7"}, Strings{"nodes=64"}, Strings{"nodes=64", "query=stack"},
                                     Strings{"nodes=64", "query=stackless"}, Strings{"nodes=64", "slab=on"}})
            asked.expectRight(query);
        expectWhole(asked.run({"cells=8", "view_cull=off"}, true), asked.scene().triangles.size());
    }
}

TEST(ForestTechnique, NodesWithoutPlanesTakeHalf) {
    for (const bool directional : {false, true}) {
        Asked asked(soup(directional));
        const auto bytes = [](const host::TechniqueResult& result) {
            return std::map<std::string, uint64_t>(result.bytes.begin(), result.bytes.end());
        };
        const uint64_t pairs = numberOf(asked.run({"cells=8"}), "pairs"), room = pairs + pairs % 2;
        const std::string pool = "pool=" + std::to_string(pairs);
        const host::TechniqueResult with = asked.run({"cells=8", "nodes=128", pool}, true), without = asked.run({"cells=8", "nodes=64", pool}, true);
        EXPECT_EQ(numberOf(with, "pairs"), pairs);
        EXPECT_EQ(numberOf(without, "pairs"), pairs);
        EXPECT_EQ(bytes(with).at("trees"), 128 * room);
        EXPECT_EQ(bytes(without).at("trees"), 64 * room);
        EXPECT_EQ(bytes(without).at("pairs"), 8 * room);
        EXPECT_TRUE(
            std::none_of(without.dump.begin(), without.dump.end(), [](const host::DumpedBuffer& buffer) { return buffer.name == "planes"; }));
    }
}

/// The same bits, computed anew: with one thread that builds, the same trees, and each sample sees the same nodes.
TEST(ForestTechnique, NodesWithoutPlanesAreTheSameTrees) {
    const char* threads = std::getenv("LP_NUM_THREADS");
    if (!threads || std::string(threads) > "1")
        GTEST_SKIP() << "invocations that insert at the same time may meet in another order: set LP_NUM_THREADS=1";
    for (const bool directional : {false, true}) {
        Asked asked(soup(directional));
        const host::TechniqueResult with = asked.run({"cells=8", "nodes=128"}, true), without = asked.run({"cells=8", "nodes=64"}, true);
        EXPECT_EQ(with.visibility, without.visibility);
        EXPECT_EQ(with.visitedNodes, without.visitedNodes);
        EXPECT_EQ(with.counters.exactCalls, without.counters.exactCalls);
        EXPECT_EQ(numberOf(with, "build_steps"), numberOf(without, "build_steps"));
        EXPECT_EQ(numberOf(with, "inserted"), numberOf(without, "inserted"));
        const auto words = [](const host::TechniqueResult& result) { return dumped<uint32_t>(result, "links"); };
        EXPECT_EQ(words(with), words(without));
    }
}

TEST(ForestTechnique, FragmentStage) {  // lavapipe 25.0 with LLVM 15 crashes when it compiles a graphics pipeline for width 16
    if (test::passes().device().facts().subgroupSize > 8) return;
    Asked asked(soup(false));
    for (const char* query : {"query=stack", "query=stackless", "query=hybrid"}) asked.expectRight({query, "stage=fragment"});
}

TEST(ForestTechnique, WhatTheViewDoesNotNeedIsLeftOut) {  // both switches do something
    Asked asked(soup(false));
    const auto pairs = [&](const char* cull, const char* cover) { return numberOf(asked.run({"cells=64", cull, cover}), "pairs"); };
    const uint64_t none = pairs("view_cull=off", "cover=off");
    EXPECT_LT(pairs("view_cull=on", "cover=off"), none);
    EXPECT_LT(pairs("view_cull=off", "cover=on"), none);
    EXPECT_LT(pairs("view_cull=on", "cover=on"), pairs("view_cull=off", "cover=on"));
}

TEST(ForestTechnique, APoolOfExactlyWhatIsNeeded) {
    for (const bool directional : {false, true}) {
        Asked asked(soup(directional));
        const uint64_t needed = numberOf(asked.run({"cells=8"}), "pairs");
        ASSERT_GT(needed, 300u);
        asked.expectRight({"cells=8", "pool=" + std::to_string(needed)});
        asked.expectRight({"cells=8", "pool=" + std::to_string(needed + 1)});
        expectWhole(asked.run({"cells=8", "pool=" + std::to_string(needed), "seed=3"}, true), asked.scene().triangles.size());
        for (const uint64_t small : {needed - 1, uint64_t(1)}) {
            const std::string text = refusal(asked, {"cells=8", "pool=" + std::to_string(small)});
            for (const std::string& part : {"pool=" + std::to_string(small), std::to_string(needed)})
                EXPECT_NE(text.find(part), std::string::npos) << text;
            EXPECT_EQ(text.find('\n'), std::string::npos) << text;
        }
    }
}

/// At first nobody knows how many pairs there will be; the frame is built again when there was no room, and the next one knows.
TEST(ForestTechnique, APoolThatWasTooSmallIsEnlarged) {
    for (const bool directional : {false, true}) {
        Asked asked(soup(directional));
        const Strings settings{"cells=256", "view_cull=off", "cover=off"};
        const host::TechniqueResult first = asked.run(settings, true);
        ASSERT_GT(numberOf(first, "pairs"), forestFirstPool(asked.inputs().casterCount())) << "the scene has to be too much";
        EXPECT_EQ(first.reruns, 1u);
        EXPECT_EQ(first.hostWaits, 0u);
        expectWhole(first, asked.scene().triangles.size());
        asked.expectRight(settings);
        asked.nextFrame();
        const host::TechniqueResult next = asked.run(settings);
        EXPECT_EQ(next.reruns, 0u);
        EXPECT_EQ(next.visibility, first.visibility);
        EXPECT_EQ(numberOf(next, "pairs"), numberOf(first, "pairs"));
        for (const auto& [name, bytes] : next.bytes)
            if (name == "pairs") {
                EXPECT_EQ(bytes, 8 * forestPoolFor(numberOf(first, "pairs")));
            }
    }
}

/// Only cells=counted reads within the frame, and says so; its choice has the least cost of all that it could have counted.
TEST(ForestTechnique, WaitsOnlyToCount) {
    for (const bool directional : {false, true}) {
        Asked asked(soup(directional));
        const auto passNamed = [](const host::TechniqueResult& result, const std::string& name) {
            return std::any_of(result.passes.begin(), result.passes.end(), [&](const host::RecordPass& pass) { return pass.name == name; });
        };
        const host::TechniqueResult known = asked.run({"cells=auto"});
        EXPECT_EQ(known.hostWaits, 0u);
        EXPECT_FALSE(passNamed(known, "host_wait"));
        EXPECT_EQ(numberOf(known, "cells"), forestResolution(asked.inputs().casterCount(), asked.inputs().sampleCount()));
        const host::TechniqueResult counted = asked.run({"cells=counted"}, true);
        EXPECT_GE(counted.hostWaits, 2u);
        EXPECT_TRUE(passNamed(counted, "host_wait"));
        for (const uint32_t resolution : {4u, 8u}) EXPECT_TRUE(passNamed(counted, "forest_setup_choose_" + std::to_string(resolution)));
        for (const host::RecordPass& pass : counted.passes) EXPECT_EQ(host::isBuildPass(pass.name), pass.name != "forest_query") << pass.name;
        expectWhole(counted, asked.scene().triangles.size());
        asked.expectRight({"cells=counted"});
        const auto cost = [&](const host::TechniqueResult& result) {
            const uint64_t cells = numberOf(result, "cells");
            return forestVisits(numberOf(result, "pairs"), numberOf(result, "used_cells"), asked.inputs().sampleCount(),
                                (directional ? 1 : 6) * cells * cells);
        };
        for (const uint32_t resolution : kForestResolutions)
            EXPECT_LE(cost(counted), cost(asked.run({"cells=" + std::to_string(resolution)}))) << resolution;
    }
}

TEST(ForestTechnique, NoCaster) {
    test::Scene scene = soup(false);
    scene.triangles.clear();
    Asked empty(scene);
    scene = soup(true);
    scene.triangles = {{{-0.5f, 0, -0.5f}, {-0.5f, 0, 0.5f}, {0.5f, 0, 0.5f}}};  // looks at the light, and is said to be of a closed mesh
    scene.closed = {1};
    scene.cull = host::Cull::front;
    Asked culled(scene);
    scene.triangles = {{{-0.5f, 0, -0.5f}, {-0.125f, 1, -0.25f}, {0.25f, 2, 0}}};  // seen edge-on
    scene.cull = host::Cull::none;
    Asked edgeOn(scene);
    for (Asked* asked : {&empty, &culled, &edgeOn})
        for (const char* cells : {"cells=1", "cells=64"})
            for (const char* pool : {"pool=0", "pool=1"}) {
                asked->expectRight({cells, pool});
                EXPECT_EQ(numberOf(asked->run({cells, pool}), "pairs"), 0u);
            }
}

TEST(ForestTechnique, AllCastersInOneCell) {
    for (const bool directional : {false, true}) {
        test::Scene scene = soup(directional);
        scene.light = directional ? scene.light : glm::vec4(-0.9375f, -0.9375f, -0.9375f, 1);
        for (host::Triangle& t : scene.triangles)
            for (glm::vec3* v : {&t.a, &t.b, &t.c}) *v = host::cases::snap(glm::dvec3(0.85, 0.8, 0.75) + 1e-3 * glm::dvec3(*v));
        for (size_t i = 0; i < scene.samples.size(); i += 2)
            scene.samples[i].position = host::cases::snap(glm::dvec3(0.85, 0.8, 0.75) + 2e-3 * glm::dvec3(scene.samples[i].position));
        scene.triangles.push_back({{-1, -1, -1}, {-1, -1, -0.9375f}, {-1, -0.9375f, -1}});  // holds a directional grid open
        Asked asked(scene);
        const host::TechniqueResult result = asked.run({"cells=4", "view_cull=off", "cover=off"}, true);
        expectWhole(result, scene.triangles.size());
        std::map<uint, size_t> perCell;
        for (const GnoForestPair& pair : dumped<GnoForestPair>(result, "pairs")) ++perCell[pair.cell];
        size_t most = 0;
        for (const auto& [cell, count] : perCell) most = std::max(most, count);
        EXPECT_GE(most, 299u) << "one cell has all the small ones but those seen edge-on";
        EXPECT_GT(std::count(asked.want().inShadow.begin(), asked.want().inShadow.end(), uint8_t(1)), 20);
        for (const char* cells : {"cells=1", "cells=4", "cells=64"}) asked.expectRight({cells});
    }
}

/// Built without the view: samples that the forest never saw get the right answer, too.
TEST(ForestTechnique, WithoutTheViewItIsTheSameForestForAnyView) {
    Asked asked(soup(false));
    test::Scene other = asked.scene();
    for (host::OracleSample& sample : other.samples) sample.position = 0.5f * sample.position;
    Asked elsewhere(other);
    const Strings settings{"cells=8", "view_cull=off", "seed=5"};
    const auto sorted = [](const host::TechniqueResult& result) {
        std::set<std::pair<uint, uint>> pairs;
        for (const GnoForestPair& pair : dumped<GnoForestPair>(result, "pairs")) pairs.insert({pair.caster, pair.cell});
        return pairs;
    };
    EXPECT_EQ(sorted(asked.run(settings, true)), sorted(elsewhere.run(settings, true)));
    asked.expectRight(settings);
    elsewhere.expectRight(settings);
    EXPECT_NE(sorted(asked.run({"cells=8", "seed=5"}, true)), sorted(elsewhere.run({"cells=8", "seed=5"}, true))) << "with the view they differ";
}

}  // namespace
}  // namespace gno
