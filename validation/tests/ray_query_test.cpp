// SPDX-License-Identifier: MIT
// Technique ray-query against the oracle: equal where no sign is near zero, nearly so on a shipped scene, and always on the casters that are kept.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "host_min/error.hpp"
#include "host_min/scene/scene.hpp"
#include "validation/support/camera_view.hpp"
#include "validation/tests/made_scenes.hpp"

namespace gno {
namespace {

using host::Precision;
using host::cases::Random;
using host::cases::snap;
using Strings = std::vector<std::string>;

constexpr uint32_t kSeed = 2016;

uint64_t shadowed(const host::OracleAnswer& answer) { return uint64_t(std::count(answer.inShadow.begin(), answer.inShadow.end(), 1)); }

uint64_t number(const host::NamedNumbers& list, const std::string& name) {
    for (const auto& [key, value] : list)
        if (key == name) return value;
    throw std::out_of_range(name);
}

host::TechniqueResult run(const test::Scene& scene, const Strings& settings = {}) {
    return test::run(scene, "ray-query", Precision::published, settings);
}

void expectTheOracles(const test::Scene& scene, uint64_t leastShadowed) {
    const host::OracleAnswer want = test::ask(scene);
    EXPECT_GE(shadowed(want), leastShadowed);
    EXPECT_GE(want.inShadow.size() - shadowed(want), leastShadowed);
    const test::Wrong wrong = test::compare(run(scene), want);
    EXPECT_EQ(wrong.wrong, 0u) << "leaks " << wrong.leaks << ", first wrong: sample " << wrong.first << " (seed " << kSeed << ")";
}

TEST(RayQuery, OneCaster) {
    for (const bool directional : {false, true}) {
        test::Scene scene = test::soup(kSeed, directional, 0, 1, 2000);
        scene.triangles = {{{-0.5f, 0.25f, -0.5f}, {0.75f, 0.375f, -0.25f}, {0, 0.25f, 0.75f}}};
        expectTheOracles(scene, 50);
    }
}

TEST(RayQuery, Soup) {
    for (const bool directional : {false, true}) expectTheOracles(test::soup(kSeed, directional, 400, 0.2, 3000), 300);
}

TEST(RayQuery, SixteenThousandCasters) {
    for (const bool directional : {false, true}) expectTheOracles(test::soup(kSeed, directional, 16384, 0.03, 3000), 300);
}

// Lavapipe 25.0 with LLVM 15 crashes when it compiles a graphics pipeline for width 16.
TEST(RayQuery, BothStagesGiveOneMask) {
    const test::Scene scene = test::soup(kSeed, false, 400, 0.3, 3000);
    const auto compute = run(scene, {"stage=compute"}).visibility;
    if (test::passes().device().facts().subgroupSize > 8) GTEST_SKIP() << "no graphics pipelines at this width";
    EXPECT_EQ(run(scene, {"stage=fragment"}).visibility, compute);
}

/// Behind its own caster a sample is lit, by the definition and by the query; a sample on none is not, nor one behind a second caster. The first
/// candidate of some rays is the own one, so the query has to go on behind it.
TEST(RayQuery, OwnCasterNeverShadows) {
    for (const bool directional : {false, true}) {
        test::Scene scene;
        scene.light = directional ? glm::vec4(0, 1, 0, 0) : glm::vec4(0, 0.9375f, 0, 1);
        const host::Triangle wide{{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}};
        const host::Triangle small{{-0.25f, 0.5f, -0.25f}, {0.25f, 0.5f, -0.25f}, {0, 0.5f, 0.25f}};
        scene.triangles = {wide, small};
        const glm::vec3 below(0, -0.25f, -0.0625f), aside(0.75f, -0.25f, -0.875f);
        scene.samples = {{aside, 0}, {aside, host::kNoCaster}, {aside, 1}, {below, 0}, {below, 1}, {below, host::kNoCaster}};
        const host::OracleAnswer want = test::ask(scene);
        EXPECT_EQ(want.inShadow, (std::vector<uint8_t>{0, 1, 1, 1, 1, 1}));
        const auto got = run(scene);
        EXPECT_EQ(test::compare(got, want).wrong, 0u);
        EXPECT_EQ(number(got.counters.more, "rays"), 6u);
        EXPECT_GE(number(got.counters.more, "candidates"), 7u);  // one per sample at least, and the own one of the fourth or fifth before the other
    }
}

/// A light in the caster's plane, a sample at the light, a sample on the caster: none of them is in shadow.
TEST(RayQuery, TiesThatAreExactInFp32) {
    test::Scene scene;
    scene.light = {0, 0.5f, 0, 1};
    scene.triangles = {{{-0.5f, 0.5f, -0.5f}, {0.5f, 0.5f, -0.5f}, {0, 0.5f, 0.5f}}};
    scene.samples = {{{0, 0.5f, 0}, host::kNoCaster}, {{0.5f, 0, 0}, host::kNoCaster}, {{0, 0.75f, 0}, host::kNoCaster}};
    const host::OracleAnswer want = test::ask(scene);
    EXPECT_EQ(want.inShadow, (std::vector<uint8_t>{0, 0, 0}));
    EXPECT_EQ(test::compare(run(scene), want).wrong, 0u);
}

TEST(RayQuery, NoCasters) {
    for (const bool directional : {false, true}) {
        const test::Scene scene = test::soup(kSeed, directional, 0, 1, 100);
        const auto got = run(scene);
        EXPECT_EQ(got.visibility, std::vector<uint32_t>(100, GNO_VISIBILITY_LIT));
        EXPECT_EQ(number(got.counters.more, "candidates"), 0u);
    }
}

/// Small tetrahedra, closed, counter-clockwise from outside.
test::Scene tetrahedra(bool directional, size_t count) {
    Random random(kSeed);
    test::Scene scene = test::soup(kSeed, directional, 0, 1, 3000);
    while (scene.triangles.size() < 4 * count) {
        const glm::dvec3 at = random.inCube(0.75);
        const auto corner = [&](double x, double y, double z) { return snap(at + 0.25 * glm::dvec3(x, y, z)); };
        const glm::vec3 a = corner(1, 1, 1), b = corner(-1, -1, 1), c = corner(-1, 1, -1), d = corner(1, -1, -1);
        for (const host::Triangle& t : {host::Triangle{a, c, b}, {a, b, d}, {a, d, c}, {b, c, d}}) scene.triangles.push_back(t);
    }
    scene.closed.assign(scene.triangles.size(), 1);
    return scene;
}

/// A caster's own vertices, or the first one three times where it is left out. How many are left.
size_t expectIndicesOfTheKept(const test::Scene& scene) {
    const host::Frame frame = test::frameOf(scene);
    host::FrameInputs inputs(test::passes(), frame, scene.samples);
    inputs.setLight(scene.light, scene.cull);
    host::StructureCache structures;
    host::Technique& technique = host::techniqueByName("ray-query");
    const auto result = technique.run(inputs, structures, host::Settings(technique.info().settings, {}),
                                      {.precision = Precision::published, .dump = true, .warmUp = false});
    std::vector<uint32_t> indices(result.dump.at(0).bytes.size() / 4);
    std::memcpy(indices.data(), result.dump.at(0).bytes.data(), 4 * indices.size());
    const auto states = inputs.states().downloadAs<uint32_t>();
    size_t kept = 0;
    for (size_t i = 0; i < scene.triangles.size(); ++i) {
        const bool isKept = (states[i] & 4u) != 0;
        kept += isKept;
        for (size_t k = 0; k < 3; ++k) EXPECT_EQ(indices.at(3 * i + k), 3 * i + (isKept ? k : 0)) << "triangle " << i;
    }
    EXPECT_EQ(kept, inputs.casterCount());
    return kept;
}

TEST(RayQuery, CulledCastersAreOut) {
    for (const bool directional : {false, true}) {
        test::Scene scene = tetrahedra(directional, 40);
        const host::OracleAnswer all = test::ask(scene);
        scene.cull = host::Cull::front;
        const host::OracleAnswer want = test::ask(scene);
        EXPECT_GT(shadowed(all), shadowed(want));  // samples inside a tetrahedron
        EXPECT_EQ(test::compare(run(scene), want).wrong, 0u);
        const size_t kept = expectIndicesOfTheKept(scene);
        EXPECT_GT(kept, 40u);
        EXPECT_LT(kept, 120u);
    }
}

TEST(RayQuery, AllCastersCulled) {
    test::Scene scene = test::soup(kSeed, false, 0, 1, 200);
    scene.light = {0, 0.5f, 0, 1};
    for (int i = -8; i < 8; ++i)  // planes through the light: seen edge-on
        scene.triangles.push_back({{float(i) / 8, -0.5f, 0}, {float(i + 1) / 8, -0.75f, 0}, {float(i) / 8, 0.25f, 0}});
    EXPECT_EQ(expectIndicesOfTheKept(scene), 0u);
    EXPECT_EQ(run(scene).visibility, std::vector<uint32_t>(200, GNO_VISIBILITY_LIT));
    EXPECT_EQ(shadowed(test::ask(scene)), 0u);
}

TEST(RayQuery, ShippedScene) {
    const host::SceneFile file = host::SceneFile::load("scenes/show_stairs.glb");
    const host::Frame frame = file.evaluate(0, 0);
    for (const bool directional : {false, true}) {
        test::CameraView view;
        view.frame = frame;
        view.width = 96;
        view.height = 72;
        view.light = directional ? glm::vec4(0.375f, 1, 0.25f, 0) : frame.lights.at(0).homogeneous;
        test::fillPixels(view);
        test::Scene scene;
        scene.triangles = frame.triangles;
        scene.closed = frame.closed;
        scene.light = view.light;
        for (const host::OracleSample& pixel : view.pixels)
            if (pixel.own <= GNO_NO_CASTER) scene.samples.push_back(pixel);
        ASSERT_GT(scene.samples.size(), 1000u);
        for (const auto cull : {host::Cull::none, host::Cull::front}) {
            scene.cull = cull;
            const host::OracleAnswer want = test::ask(scene);
            EXPECT_GT(shadowed(want), 100u);
            const test::Wrong wrong = test::compare(run(scene), want);
            std::printf("show_stairs, %s, cull %u: %llu of %zu wrong\n", directional ? "directional" : "point", uint32_t(cull),
                        (unsigned long long)wrong.wrong, scene.samples.size());
            EXPECT_LE(wrong.wrong, scene.samples.size() / 1000);
            EXPECT_GT(expectIndicesOfTheKept(scene), 1000u);
        }
    }
}

TEST(RayQuery, ADeviceWithoutItIsTold) {
    const host::TechniqueInfo& info = host::techniqueByName("ray-query").info();
    host::DeviceFacts facts = test::passes().device().facts();
    EXPECT_EQ(host::missingFor(info, facts), "");
    facts.rayQuery = false;
    const std::string missing = host::missingFor(info, facts);
    EXPECT_NE(missing.find("rayQuery"), std::string::npos) << missing;
    EXPECT_EQ(missing.find('\n'), std::string::npos);
    EXPECT_EQ(host::missingFor(host::techniqueByName("d-hybrid").info(), facts), "");
}

TEST(RayQuery, PassesAndBytes) {
    const test::Scene scene = test::soup(kSeed, false, 400, 0.3, 3000);
    const auto result = run(scene);
    double build = 0, query = 0;
    for (const host::RecordPass& pass : result.passes) (host::isBuildPass(pass.name) ? build : query) += pass.ms;
    EXPECT_GT(build, 0);
    EXPECT_GT(query, 0);
    EXPECT_EQ(number(result.bytes, "indices"), 400u * 12u);
    EXPECT_GT(number(result.bytes, "bottom_level"), 400u * 36u);
    EXPECT_GT(number(result.bytes, "top_level"), 0u);
    EXPECT_EQ(number(result.counters.more, "rays"), 3000u);
}

}  // namespace
}  // namespace gno
