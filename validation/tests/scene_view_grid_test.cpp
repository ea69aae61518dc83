// SPDX-License-Identifier: MIT
// The grid of a view: far lights and objects, distant cameras, origins far away, what is measured about it, and that it stays over frames.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "far_scene.hpp"

namespace gno::host::test {
namespace {

constexpr uint32_t kWidth = Street::kWidth, kHeight = Street::kHeight;

const glm::dvec3 kUp = glm::normalize(glm::dvec3(0.4, 1, 0.3));

/// Largest distance, pixels, between where vertices of triangles [first, last) lie in the picture on the grid and where they should; those inside
/// only.
double movedPixels(const Frame& frame, const std::vector<glm::dvec3>& exact) {
    const glm::dmat4 clip = frame.camera.clipFromGrid(double(kWidth) / kHeight);
    const auto pixel = [&](glm::dvec3 onGrid, bool& inside) {
        const glm::dvec4 p = clip * glm::dvec4(onGrid, 1);
        inside = p.w > 0 && std::abs(p.x) <= p.w && std::abs(p.y) <= p.w && p.z <= p.w;
        return glm::dvec2(p.x / p.w * kWidth / 2, p.y / p.w * kHeight / 2);
    };
    double most = 0;
    for (const glm::dvec3& p : exact) {
        bool inside = false, ignored = false;
        const glm::dvec2 want = pixel((p - frame.grid.origin) * frame.grid.scale(), inside), got = pixel(frame.grid.snap(p), ignored);
        if (inside) most = std::max(most, glm::distance(want, got));
    }
    return most;
}

std::vector<glm::dvec3> cubeCorners(glm::dvec3 at) {
    std::vector<glm::dvec3> corners;
    for (int i = 0; i < 8; ++i) corners.push_back(at + glm::dvec3(i & 1, i >> 1 & 1, i >> 2) * glm::dvec3(0.7, 1.3, 0.9));
    return corners;
}

TEST(ViewGrid, ALightMayStandAnywhere) {
    for (int exponent = 0; exponent <= 15; ++exponent) {
        SCOPED_TRACE(exponent);
        Street street;
        const glm::dvec3 at = kUp * 3.0 * std::pow(10.0, exponent);
        street.pointLight(at);
        const Frame frame = street.frame();
        EXPECT_LT(frame.harm.movedPixels, 1e-3);
        EXPECT_LT(frame.harm.lightArcsec, 0.1);
        const Light& light = frame.lights[0];
        EXPECT_EQ(light.isFar, light.homogeneous.w == 0);
        EXPECT_EQ(light.isFar, exponent >= 6) << light.parallaxPixels;
        if (light.isFar) {
            EXPECT_LT(light.parallaxPixels, kFarParallax);
            EXPECT_LT(frame.grid.exponent, 6);
            EXPECT_LT(glm::length(glm::cross(glm::normalize(glm::dvec3(light.homogeneous)), kUp)), 20 / glm::length(at) + 6e-8);
        } else {
            EXPECT_LT(glm::distance(frame.grid.world(glm::vec3(light.homogeneous)), at), glm::length(at) * 1e-7);
        }
    }
}

TEST(ViewGrid, ParallaxIsAnUpperBound) {  // of how far the corner of the cube's shadow on the floor really goes
    for (const double distance : {3e2, 3e3, 1e4, 3e5, 3e6}) {
        SCOPED_TRACE(distance);
        Street street;
        const glm::dvec3 at = kUp * distance;
        street.pointLight(at);
        Frame frame = street.frame();
        if (!frame.lights[0].isFar) continue;
        const glm::dvec3 towards = glm::normalize(glm::dvec3(frame.lights[0].homogeneous));
        const glm::dmat4 clip = frame.camera.clipFromGrid(double(kWidth) / kHeight);
        for (const glm::dvec3& corner : cubeCorners(glm::dvec3(0))) {
            const auto shadow = [&](glm::dvec3 direction) { return corner - direction * (corner.y / direction.y); };
            const auto pixel = [&](glm::dvec3 p) {
                const glm::dvec4 c = clip * glm::dvec4((p - frame.grid.origin) * frame.grid.scale(), 1);
                return glm::dvec2(c.x / c.w * kWidth / 2, c.y / c.w * kHeight / 2);
            };
            EXPECT_LE(glm::distance(pixel(shadow(at - corner)), pixel(shadow(towards))), frame.lights[0].parallaxPixels);
        }
    }
}

TEST(ViewGrid, AFarObjectHarmsNobody) {
    Street street;
    street.pointLight({1.5, 4, 1});
    street.triangleAt({1e6, 1e6, -1e6}, 1000);
    const Frame frame = street.frame();
    EXPECT_LT(frame.harm.movedPixels, 1e-3);
    EXPECT_NEAR(frame.harm.movedPixels, std::max(frame.harm.movedPixels, movedPixels(frame, cubeCorners(glm::dvec3(0)))), 1e-12);
    for (const glm::dvec3& corner : cubeCorners(glm::dvec3(0))) EXPECT_LT(glm::distance(frame.grid.world(frame.grid.snap(corner)), corner), 3e-6);
}

TEST(ViewGrid, OnlyLightsThatAreAskedForCount) {
    Street street;
    street.pointLight({1.5, 4, 1});
    street.pointLight(kUp * 1e4);  // too near to be directional
    EXPECT_LT(street.frame(0).grid.exponent, 6);
    EXPECT_GT(street.frame(1).grid.exponent, 12);
    EXPECT_EQ(street.frame().grid, street.frame(1).grid);
    EXPECT_NE(inputError([&] { (void)street.frame(2); }).find("light 2 does not exist"), std::string::npos);
}

TEST(ViewGrid, ACameraMayBeFarAwayAndNarrow) {
    for (const double distance : {1e3, 1e5, 1e7}) {
        SCOPED_TRACE(distance);
        Street street(glm::dvec3(0), distance, 5 / distance);
        street.pointLight({1.5, 4, 1});
        const Frame frame = street.frame();
        EXPECT_LT(frame.harm.movedPixels, 1e-3);
        // What the device multiplies: a matrix of floats, and floats as positions.
        const glm::mat4 clip(frame.camera.clipFromGrid(double(kWidth) / kHeight));
        const glm::dmat4 exact = frame.camera.clipFromGrid(double(kWidth) / kHeight);
        for (const glm::dvec3& corner : cubeCorners(glm::dvec3(0))) {
            const glm::vec4 got = clip * glm::vec4(frame.grid.snap(corner), 1);
            const glm::dvec4 want = exact * glm::dvec4((corner - frame.grid.origin) * frame.grid.scale(), 1);
            EXPECT_NEAR(got.x / got.w * kWidth / 2, want.x / want.w * kWidth / 2, 0.01);
            EXPECT_NEAR(got.y / got.w * kHeight / 2, want.y / want.w * kHeight / 2, 0.01);
        }
    }
}

TEST(ViewGrid, AMovedSceneKeepsItsGridPositions) {
    Street near;
    near.pointLight({1.5, 4, 1});
    const Frame want = near.frame();
    for (const double by : {0x1p10, 0x1p18}) {  // the cube's corners, of 24 bits, and the camera's place are exact in double there, too
        Street far(glm::dvec3(by, -by, by));
        far.pointLight(glm::dvec3(1.5, 4, 1) + glm::dvec3(by, -by, by));
        const Frame got = far.frame();
        EXPECT_EQ(got.grid.origin - want.grid.origin, glm::dvec3(by, -by, by));
        ASSERT_EQ(got.triangles.size(), want.triangles.size());
        for (size_t i = 0; i < got.triangles.size(); ++i)
            EXPECT_TRUE(got.triangles[i].a == want.triangles[i].a && got.triangles[i].b == want.triangles[i].b) << i;
        EXPECT_EQ(got.lights[0].homogeneous, want.lights[0].homogeneous);
    }
}

TEST(ViewGrid, HarmIsMeasured) {  // a light that cannot be directional, because something huge lies between it and what is seen
    Street street;
    street.pointLight(kUp * 6e11);
    street.triangleAt(kUp * 3.9e11, 1e10f);
    const Frame frame = street.frame();
    EXPECT_FALSE(frame.lights[0].isFar);
    EXPECT_EQ(frame.harm.forLight, 0);
    EXPECT_GT(frame.harm.reach, 1e11);
    EXPECT_GT(frame.harm.movedPixels, kHarmRefused);
    const double cube = movedPixels(frame, cubeCorners(glm::dvec3(0)));
    EXPECT_GT(cube, kHarmRefused);
    EXPECT_NEAR(frame.harm.movedPixels, std::max(cube, frame.harm.movedPixels), 0.05 * cube);
    EXPECT_GE(frame.harm.movedPixels, cube * 0.95);  // first order against the real thing

    Street nearer;  // triangles, too
    nearer.pointLight({1.5, 4, 1});
    nearer.triangleAt({0, 4e11, 0}, 1e10f);
    EXPECT_EQ(nearer.frame().harm.forLight, -1);
    EXPECT_GT(nearer.frame().harm.movedPixels, kHarmRefused);
}

TEST(ViewGrid, WhatTheBorderCutsIsMeasured) {  // a tilted plane, far larger than the picture: all its vertices lie outside
    Street street;
    street.pointLight({1.5, 40, 1});
    const std::vector<float> corners{-3e6f, -1e6f, -2e6f, 4e6f, 1.1e6f, -2.5e6f, 1e6f, 3e5f, 5e6f};
    street.builder.meshNode(corners);
    const Frame frame = street.frame();
    glm::dvec3 exact[3], snapped[3];
    for (int i = 0; i < 3; ++i) {
        exact[i] = {corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]};
        snapped[i] = frame.grid.world(frame.grid.snap(exact[i]));
    }
    // Along the middle ray of view.
    const glm::dvec3 eye = frame.grid.world(glm::dvec3(frame.camera.gridFromCamera[3])), along = -glm::dvec3(frame.camera.gridFromCamera[2]);
    const auto depth = [&](const glm::dvec3* t) {
        const glm::dvec3 n = glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0]));
        return std::pair(glm::dot(n, t[0] - eye) / glm::dot(n, along), n);
    };
    const auto [want, normal] = depth(exact);
    const double moved = std::abs(glm::dot(normal, along) * (depth(snapped).first - want));  // across the plane, world units
    const glm::dvec3 across = normal - along * glm::dot(normal, along);
    const double pixel = 2 * std::tan(0.35) * want / kHeight;
    EXPECT_GT(want, 0);
    EXPECT_GE(frame.harm.movedPixels, moved * glm::length(across) / pixel * 0.5);  // it is measured at the picture's border
    EXPECT_GT(frame.harm.movedPixels, 0);
}

TEST(ViewGrid, StaysOverFrames) {
    Street street;
    street.pointLight({1.5, 4, 1});
    Builder& builder = street.builder;
    const int times = builder.floats({0, 1}, "SCALAR", 1), values = builder.positions({1, 4, 6, 4e6, 4, 6});
    builder.json["animations"] = {{{"samplers", {{{"input", times}, {"output", values}}}},
                                   {"channels", {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "translation"}}}}}}}};
    const int still = builder.positions({1, 4, 6, 1.2f, 4.1f, 6.3f});
    builder.json["animations"][0]["samplers"][0]["output"] = still;
    const SceneFile near = street.file();

    const Grid first = near.evaluate(0, View{0, kWidth, kHeight}).grid;
    std::optional<Grid> before;
    for (uint32_t number = 0; number <= 30; number += 5) {
        const Frame frame = near.evaluate(number, View{0, kWidth, kHeight, std::nullopt, before});
        EXPECT_EQ(frame.grid, first);
        EXPECT_FALSE(frame.harm.changed);
        EXPECT_EQ(near.evaluate(number, View{0, kWidth, kHeight}).grid, first);  // alone, too
        before = frame.grid;
    }
    // A triangle that comes before the camera a million units away moves by more than a tenth of a pixel on the first grid.
    street.triangleAt({4e6 + 0.3, 2.1, 0}, 0.7f);
    builder.json["animations"][0]["samplers"][0]["output"] = values;
    const SceneFile flight = street.file();
    const Frame start = flight.evaluate(0, View{0, kWidth, kHeight});
    const Frame end = flight.evaluate(30, View{0, kWidth, kHeight, std::nullopt, start.grid});
    EXPECT_TRUE(end.harm.changed);
    EXPECT_LT(end.harm.movedPixels, kHarmTold);
    EXPECT_EQ(flight.evaluate(30, View{0, kWidth, kHeight, std::nullopt, end.grid}).grid, end.grid);
}

}  // namespace
}  // namespace gno::host::test
