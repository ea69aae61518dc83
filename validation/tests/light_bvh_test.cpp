// SPDX-License-Identifier: MIT
// Technique light-bvh: the hierarchy that a device built, read back and held against the casters in double; its answers against the oracle's, exact,
// with any stack and without one; pools that are full, too small and empty.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "glsl/forest/cells.h"
#include "host_min/error.hpp"
#include "host_min/techniques/light_bvh_tree.hpp"
#include "validation/support/device_test.hpp"
#include "validation/support/light_bvh_walk.hpp"
#include "validation/tests/oracle_cases.hpp"

namespace gno {
namespace {

using host::Precision;
using host::cases::Random;
using host::cases::snap;
using Strings = std::vector<std::string>;

constexpr uint32_t kSeed = 1966;
const glm::vec4 kPoint(0.125f, 0.25f, -0.25f, 1), kDirection(0.375f, 1, 0.25f, 0);

/// Casters around the light as well as far from it; every sixteenth is large.
std::vector<host::Triangle> soup(size_t count, double size) {
    Random random(kSeed);
    std::vector<host::Triangle> triangles;
    while (triangles.size() < count) {
        const double half = triangles.size() % 16 == 5 ? 0.5 : size;
        const glm::dvec3 at = random.inCube(1 - half);
        const auto corner = [&] { return snap(at + random.inCube(half)); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        triangles.push_back({a, b, c});
    }
    return triangles;
}

test::Scene sceneOf(std::vector<host::Triangle> triangles, glm::vec4 light, size_t samples = 3000) {
    Random random(kSeed + 1);
    test::Scene scene;
    scene.light = light;
    scene.triangles = std::move(triangles);
    while (scene.samples.size() < samples) scene.samples.push_back({snap(random.inCube()), host::kNoCaster});
    return scene;
}

uint64_t number(const host::NamedNumbers& list, const std::string& name) {
    for (const auto& [key, value] : list)
        if (key == name) return value;
    throw std::out_of_range(name);
}

template <class T>
std::vector<T> part(const std::vector<host::DumpedBuffer>& dump, const std::string& name) {
    for (const host::DumpedBuffer& buffer : dump) {
        if (buffer.name != name) continue;
        std::vector<T> result(buffer.bytes.size() / sizeof(T));
        std::memcpy(result.data(), buffer.bytes.data(), result.size() * sizeof(T));
        return result;
    }
    throw std::out_of_range(name);
}

/// Face and cell of a point in double; none when it lies too near to a border to tell.
std::optional<glm::uvec3> cellOf(const GnoForestGrid& grid, glm::vec4 light, const glm::dvec3& p) {
    const auto index = [&](double place, double least, double step) -> int64_t {
        const double at = (place - least) / step;
        if (std::abs(at - std::round(at)) < 0.1) return -1;  // fp32 may see it in the next one
        return int64_t(std::clamp(at, 0.0, double(grid.resolution - 1)));
    };
    glm::dvec3 turned;
    uint32_t face = 0;
    if (light.w == 0) {
        turned = {glm::dot(glm::dvec3(grid.across), p), glm::dot(glm::dvec3(grid.along), p), 1};
    } else {
        const glm::dvec3 q = p - glm::dvec3(light), far = glm::abs(q);
        const int axis = far.x >= far.y && far.x >= far.z ? 0 : far.y >= far.z ? 1 : 2;
        for (int other = 0; other < 3; ++other)
            if (other != axis && far[other] > 0.999 * far[axis]) return std::nullopt;
        face = uint32_t(2 * axis + (q[axis] < 0));
        turned = {q[(axis + 1) % 3], q[(axis + 2) % 3], far[axis]};
    }
    const int64_t x = index(turned.x / turned.z, grid.across.w, grid.stepAcross), y = index(turned.y / turned.z, grid.along.w, grid.stepAlong);
    if (x < 0 || y < 0) return std::nullopt;
    return glm::uvec3(x, y, face);
}

double depthOf(glm::vec4 light, const glm::dvec3& p) {
    return light.w == 0 ? 4 - glm::dot(glm::dvec3(light), p) : glm::length(p - glm::dvec3(light));
}

/// Builds one hierarchy and checks all of it; returns the number of its references.
uint64_t expectSound(const std::vector<host::Triangle>& triangles, glm::vec4 light, uint32_t pool = 0) {
    SCOPED_TRACE(fmt::format("{} casters, {}, pool {}", triangles.size(), light.w == 0 ? "directional" : "point", pool));
    test::Scene scene = sceneOf(triangles, light, 1);
    const host::Frame frame = test::frameOf(scene);
    host::FrameInputs inputs(test::passes(), frame, scene.samples);
    inputs.setLight(light, host::Cull::none);
    const auto tree = host::built<host::LightBvhTree>(inputs, host::LightBvhOptions{pool});
    const auto dump = tree.dump();
    const GnoForestGrid grid = part<GnoForestGrid>(dump, "grid").front();
    const auto header = part<GnoLightBvhHeader>(dump, "light_bvh_header").front();
    test::LightBvhWalk walk{.triangles = triangles, .light = light};
    walk.nodes = part<GnoLightBvhNode>(dump, "nodes");
    walk.parents = part<uint32_t>(dump, "parents");
    const uint64_t nodes = walk.all(header.roots);
    EXPECT_EQ(walk.error, "");
    EXPECT_EQ(walk.leaves.size(), header.references);
    EXPECT_EQ(nodes, tree.nodes());
    EXPECT_LE(nodes, gnoLightBvhNodes(header.references));

    // No point of a shadow volume is outside its caster's bounds, or nearer to the light than its least depth.
    Random random(kSeed + 2);
    size_t told = 0;
    for (uint32_t caster = 0; caster < triangles.size(); ++caster) {
        const host::Triangle& t = triangles[caster];
        if (test::lightBvhFacing(t, light) == 0) {
            for (uint32_t face = 0; face < 6; ++face) EXPECT_FALSE(walk.leaves.contains({face, caster})) << "edge-on caster " << caster;
            continue;
        }
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 dice = glm::abs(random.inCube(1)) + 1e-3;
            const glm::dvec3 weights = i < 3 ? glm::dvec3(i == 0, i == 1, i == 2) * 0.9997 + 0.0001 : dice / (dice.x + dice.y + dice.z);
            const glm::dvec3 on = weights.x * glm::dvec3(t.a) + weights.y * glm::dvec3(t.b) + weights.z * glm::dvec3(t.c);
            const glm::dvec3 away = light.w == 0 ? -glm::dvec3(light) : on - glm::dvec3(light);
            const auto cell = cellOf(grid, light, on + 0.01 * double(i) * away);
            if (!cell) continue;
            ++told;
            const auto leaf = walk.leaves.find({cell->z, caster});
            if (leaf == walk.leaves.end()) {
                ADD_FAILURE() << "caster " << caster << " has no reference on face " << cell->z << " (seed " << kSeed << ")";
                return header.references;
            }
            EXPECT_TRUE(leaf->second.holds(glm::uvec2(*cell)))
                << "caster " << caster << ", cell " << cell->x << " " << cell->y << ", face " << cell->z;
            EXPECT_LE(double(leaf->second.least), depthOf(light, on) + 1e-9) << "caster " << caster;
        }
    }
    EXPECT_GE(told, triangles.size());
    return header.references;
}

TEST(LightBvh, IsSound) {
    for (const glm::vec4 light : {kPoint, kDirection})
        for (const size_t count : {1, 2, 3, 5, 63, 64, 65, 1025}) expectSound(soup(count, 0.05), light);
}

/// All keys are equal: the places of the references alone make the tree.
TEST(LightBvh, OneCasterManyTimes) {
    for (const glm::vec4 light : {kPoint, kDirection}) EXPECT_GE(expectSound(std::vector<host::Triangle>(700, soup(1, 0.05).front()), light), 700u);
}

/// Small casters on few faces cost one reference each, wherever the light is.
TEST(LightBvh, ReferencesAreFew) {
    EXPECT_EQ(expectSound(soup(1000, 0.05), kDirection), 1000u);
    const uint64_t references = expectSound(soup(1000, 0.01), kPoint);
    EXPECT_GE(references, 1000u);
    EXPECT_LE(references, 1250u);
}

void expectTheOracles(const test::Scene& scene, const Strings& settings = {}) {
    const host::OracleAnswer want = test::ask(scene);
    for (const Precision precision : {Precision::certified, Precision::conservative}) {
        const test::Wrong wrong = test::compare(test::run(scene, "light-bvh", precision, settings), want);
        EXPECT_EQ(wrong.wrong, 0u) << name(precision) << ", leaks " << wrong.leaks << ", first wrong: sample " << wrong.first << " (seed " << kSeed
                                   << ")";
    }
}

TEST(LightBvh, AnswersAsTheOracle) {
    for (const glm::vec4 light : {kPoint, kDirection})
        for (const size_t count : {1, 2, 300, 3000}) expectTheOracles(sceneOf(soup(count, count > 1000 ? 0.03 : 0.1), light));
}

/// One entry overflows at once, and nothing is lost by it.
TEST(LightBvh, AnyStackAndNoneAtAll) {
    for (const glm::vec4 light : {kPoint, kDirection}) {
        const test::Scene scene = sceneOf(soup(600, 0.1), light);
        const auto plain = test::run(scene, "light-bvh", Precision::certified);
        EXPECT_EQ(plain.counters.stackOverflows, 0u);
        EXPECT_GT(plain.counters.maxStack, 2u);
        for (const Strings& settings : {Strings{"stack=1"}, Strings{"stack=2"}, Strings{"query=stackless"}}) {
            const auto got = test::run(scene, "light-bvh", Precision::certified, settings);
            EXPECT_EQ(got.visibility, plain.visibility) << settings.front();
            EXPECT_EQ(got.counters.stackOverflows > 0, settings.front() != "query=stackless") << settings.front();
        }
        expectTheOracles(scene, {"stack=1"});
    }
}

// Lavapipe 25.0 with LLVM 15 crashes when it compiles a graphics pipeline for width 16.
TEST(LightBvh, BothStagesGiveOneMask) {
    if (test::passes().device().facts().subgroupSize > 8) GTEST_SKIP() << "no graphics pipelines at this width";
    const test::Scene scene = sceneOf(soup(400, 0.1), kPoint);
    const auto compute = test::run(scene, "light-bvh", Precision::certified).visibility;
    for (const Strings& settings : {Strings{"stage=fragment"}, Strings{"stage=fragment", "query=stackless"}})
        EXPECT_EQ(test::run(scene, "light-bvh", Precision::certified, settings).visibility, compute) << settings.back();
}

TEST(LightBvh, NobodyCasts) {
    for (const glm::vec4 light : {kPoint, kDirection}) {
        const glm::vec3 up(light.x, light.y, light.z), on = light.w == 0 ? glm::vec3(0) : up;
        const std::vector<host::Triangle> edgeOn(70, {on, on + 0.5f * up, on - 0.25f * up});
        for (const auto& triangles : {std::vector<host::Triangle>{}, edgeOn}) {
            const auto got = test::run(sceneOf(triangles, light, 100), "light-bvh", Precision::certified);
            EXPECT_EQ(got.visibility, std::vector<uint32_t>(100, GNO_VISIBILITY_LIT));
            EXPECT_EQ(number(got.counters.more, "references"), 0u);
            EXPECT_EQ(got.counters.visitedNodes, 0u);
        }
    }
}

/// The light lies in the middle of a closed box, on a caster, and at a vertex; casters reach over faces, edges and corners of its cube.
TEST(LightBvh, AroundTheLight) {
    std::vector<host::Triangle> box;
    host::cases::addBox(box, {-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f});
    for (const glm::vec4 light :
         {glm::vec4(0, 0, 0, 1), glm::vec4(0.5f, 0, 0, 1), glm::vec4(0.5f, 0.5f, 0.5f, 1), glm::vec4(0, 0, 0.5f - 0x1p-30f, 1), kDirection}) {
        expectSound(box, light);
        expectTheOracles(sceneOf(box, light));
    }
}

TEST(LightBvh, PoolExactlyFullAndOneTooSmall) {
    for (const glm::vec4 light : {kPoint, kDirection}) {
        const test::Scene scene = sceneOf(soup(200, 0.1), light);
        const auto plain = test::run(scene, "light-bvh", Precision::certified);
        const auto references = uint32_t(number(plain.counters.more, "references"));
        EXPECT_EQ(expectSound(scene.triangles, light, references), references);
        for (const uint32_t pool : {references, references + 1, 4096u})
            EXPECT_EQ(test::run(scene, "light-bvh", Precision::certified, Strings{fmt::format("pool={}", pool)}).visibility, plain.visibility)
                << pool;
        try {
            test::run(scene, "light-bvh", Precision::certified, Strings{fmt::format("pool={}", references - 1)});
            ADD_FAILURE() << "a pool that is too small was taken";
        } catch (const host::InputError& error) {
            EXPECT_EQ(std::string(error.what()), fmt::format("--set pool={}: the light-space hierarchy needs {} references: use a larger pool, or 0",
                                                             references - 1, references));
        }
    }
}

}  // namespace
}  // namespace gno
