// SPDX-License-Identifier: MIT
// "When all samples lie farther from the light than all casters", Mora et al., EGSR 2016, section 4.3: the depth test never passes, so that
// D-PSV visits exactly the nodes of PSV.
#include <gtest/gtest.h>

#include <random>

#include "host_min/scene/grid.hpp"
#include "validation/support/device_test.hpp"

namespace gno {
namespace {

constexpr uint32_t kSeed = 20161;

test::Scene farSamples(bool directional) {
    std::mt19937 random(kSeed);
    const auto unit = [&] { return double(random()) / 4294967296.0; };
    const auto point = [&](double x, double y, double z) {
        return glm::vec3(host::snapCoordinate(x), host::snapCoordinate(y), host::snapCoordinate(z));
    };
    test::Scene scene;
    scene.light = directional ? glm::vec4(host::snapDirection({0.2, 1.0, 0.1}), 0) : glm::vec4(point(0.1, 0.9, 0.05), 1);
    for (int i = 0; i < 3000; ++i) {
        const double x = unit() - 0.5, y = 0.2 + 0.2 * unit(), z = unit() - 0.5;
        const auto corner = [&] { return point(x + 0.05 * unit(), y + 0.05 * unit(), z + 0.05 * unit()); };
        scene.triangles.push_back({corner(), corner(), corner()});
    }
    for (int i = 0; i < 4096; ++i) scene.samples.push_back({point(1.2 * unit() - 0.6, -0.95, 1.2 * unit() - 0.6), host::kNoCaster});
    return scene;
}

void expectSameVisits(bool directional) {
    std::printf("seed %u\n", kSeed);
    const test::Scene scene = farSamples(directional);
    for (const auto precision : {host::Precision::published, host::Precision::conservative, host::Precision::certified}) {
        const std::vector<std::string> both{"psv", "d-psv"};  // on one tree
        const auto results = test::runAll(scene, both, precision);
        EXPECT_EQ(results[0].visibility, results[1].visibility);
        EXPECT_EQ(results[0].visitedNodes, results[1].visitedNodes);
        EXPECT_GT(results[0].counters.visitedNodes, 4096u);
    }
}

// The comparison above can fail: with one caster behind the samples the depth test has something to skip.
TEST(TopFarSamples, NearSamplesDiffer) {
    test::Scene scene = farSamples(false);
    for (host::OracleSample& sample : scene.samples) sample.position.y = 0.5f;
    const std::vector<std::string> both{"psv", "d-psv"};
    const auto results = test::runAll(scene, both, host::Precision::certified);
    EXPECT_LT(results[1].counters.visitedNodes, results[0].counters.visitedNodes);
}

TEST(TopFarSamples, PointLight) { expectSameVisits(false); }
TEST(TopFarSamples, DirectionalLight) { expectSameVisits(true); }

}  // namespace
}  // namespace gno
