// SPDX-License-Identifier: MIT
// What is hard for a hierarchy of view samples: samples where a camera sees them, at the ends of its depth range, crowded or alone.
#include <algorithm>
#include <cmath>

#include "validation/hard_cases/hard_case.hpp"
#include "validation/hard_cases/scene_maker.hpp"
#include "validation/support/camera_view.hpp"

namespace gno::hard {
namespace {

using glm::dvec3;

/// Casters of all sizes over a floor.
std::vector<Triangle> overFloor(Random& random, size_t count) {
    std::vector<Triangle> triangles;
    addQuad(triangles, {-1, -0.75f, -1}, {-1, -0.75f, 1}, {1, -0.75f, 1}, {1, -0.75f, -1});
    while (triangles.size() < count) {
        const dvec3 at = random.inCube(0.6);
        const double size = std::ldexp(0.5, -int(random.below(5)));
        const auto corner = [&] { return snapped(at + size * random.inCube(0.7)); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        triangles.push_back({a, b, c});
    }
    return triangles;
}

test::CameraView viewOf(std::vector<Triangle> triangles, glm::vec4 light, dvec3 eye, dvec3 at, double extent = 0.5, bool perspective = true) {
    test::CameraView view;
    view.width = 44;
    view.height = 29;
    view.light = light;
    view.frame.triangles = std::move(triangles);
    view.frame.camera = test::lookAt(eye, at, extent, perspective);
    return view;
}

test::Scene sceneOf(const test::CameraView& view) {
    test::Scene scene;
    scene.triangles = view.frame.triangles;
    scene.light = view.light;
    scene.samples = view.pixels;
    scene.camera = view.frame.camera;
    scene.width = view.width;
    return scene;
}

test::Scene seen(test::CameraView view) {
    fillPixels(view);
    return sceneOf(view);
}

glm::vec4 anyLight(uint32_t seed) { return seed % 2 ? pointLight({0.3, 0.95, 0.2}) : directionalLight({0.4, 1, 0.3}); }

test::CameraView plain(uint32_t seed) {
    Random random(seed);
    return viewOf(overFloor(random, 40), anyLight(seed), {0.3, 0.5, 0.95}, {0, -0.4, -0.2});
}

test::Scene farPlane(uint32_t seed) {  // everything that is not a caster's front lies at one depth, the largest: a wall across the view
    Random random(seed);
    std::vector<Triangle> triangles = overFloor(random, 24);
    triangles.erase(triangles.begin(), triangles.begin() + 2);
    addQuad(triangles, {-1, -1, -0.75f}, {1, -1, -0.75f}, {1, 1, -0.75f}, {-1, 1, -0.75f});
    test::CameraView view =
        viewOf(triangles, seed % 2 ? pointLight({0.3, 0.4, 0.95}) : directionalLight({0.2, 0.3, 1}), {0, 0, 1}, {0, 0, 0}, 0.5, seed < 3);
    view.frame.camera.zfar = 1.75;
    return seen(view);
}

test::Scene everyDepth(uint32_t seed) {  // no two samples of a tile in one slice
    Random random(seed);
    test::CameraView view = plain(seed);
    std::vector<double> depths;
    for (uint32_t i = 0; i < view.width * view.height; ++i) depths.push_back(1.4 * std::pow(2.0, -10.0 * random.real(0, 1)));
    fillPixels(view, depths);
    return sceneOf(view);
}

test::Scene few(uint32_t seed, uint32_t samples) {
    Random random(seed);
    test::CameraView view = plain(seed);
    view.width = 333;
    view.height = 217;
    fillPixels(view);
    std::vector<host::OracleSample> kept(view.pixels.size(), {glm::vec3(0), GNO_BACKGROUND});
    for (uint32_t i = 0; i < samples;) {
        const uint32_t at = random.below(uint32_t(kept.size()));
        if (view.pixels[at].own > GNO_NO_CASTER) continue;
        kept[at] = view.pixels[at];
        ++i;
    }
    view.pixels = kept;
    return sceneOf(view);
}

test::Scene cameraInVolume(uint32_t seed) {  // a lid between light and camera: near clusters are dark, far ones are not
    Random random(seed);
    std::vector<Triangle> triangles = overFloor(random, 30);
    triangles.push_back({{0.125f, 0.75f, 0.5f}, {0.625f, 0.75f, 0.625f}, {0.25f, 0.75f, 1}});
    return seen(viewOf(triangles, anyLight(seed), {0.3, 0.5, 0.7}, {0, -0.4, -0.2}));
}

test::Scene cameraAtLight(uint32_t seed) {
    Random random(seed);
    return seen(viewOf(overFloor(random, 40), pointLight({0.25, 0.5, 0.875}), {0.25, 0.5, 0.875}, {0, -0.4, -0.2}));
}

test::Scene millionfold(uint32_t seed) {  // samples from 2 millionths of a unit to 2 units away
    Random random(seed);
    test::CameraView view = plain(seed);
    view.frame.camera.znear = 1e-6;
    std::vector<double> depths;
    for (uint32_t i = 0; i < view.width * view.height; ++i) {
        const double most = 1.5, least = most * 1e-6;
        depths.push_back(i % view.width < 4 ? least : least * std::pow(most / least, double(i % view.width) / view.width));
    }
    fillPixels(view, depths);
    return sceneOf(view);
}

test::Scene around(uint32_t seed) {  // a box around camera, frustum and all
    Random random(seed);
    std::vector<Triangle> triangles = overFloor(random, 20);
    addBox(triangles, {-0.875f, -0.875f, -0.875f}, {0.875f, 0.875f, 0.96875f});
    const glm::vec4 light = seed == 1 ? pointLight({0.3, 0.8, 0.2}) : seed == 2 ? pointLight({0.95, 0.95, 0.2}) : directionalLight({0.4, 1, 0.3});
    return seen(viewOf(triangles, light, {0.3, 0.5, 0.9}, {0, -0.4, -0.2}, 1.2));
}

}  // namespace

std::vector<HardCase> clusters() {
    const auto seenPlain = [](uint32_t seed) { return seen(plain(seed)); };
    return {
        {.name = "samples on the far plane",
         .why = "the largest depth is the end of the last slice, not the beginning of one more",
         .make = farPlane,
         .scenes = 4},
        {.name = "64 depths in a tile", .why = "every sample of a tile is a cluster of its own", .make = everyDepth, .scenes = 2},
        {.name = "one sample in all the screen",
         .why = "one path from the root to a leaf",
         .make = [](uint32_t seed) { return few(seed, 1); },
         .scenes = 2},
        {.name = "no sample in all the screen", .why = "no depth range, no node", .make = [](uint32_t seed) { return few(seed, 0); }},
        {.name = "camera inside a caster's volume", .why = "planes cut the frustum near its tip", .make = cameraInVolume, .scenes = 2},
        {.name = "camera at the light",
         .why = "planes through the light contain the lines of sight: every cell touches many",
         .make = cameraAtLight},
        {.name = "near and far a million apart",
         .why = "slices cannot be as deep as wide: the near end shares one",
         .make = millionfold,
         .scenes = 2},
        {.name = "a caster around the whole frustum",
         .why = "nodes lie wholly inside volumes, or no plane rejects them",
         .make = around,
         .scenes = 3},
        {.name = "a job list of one entry",
         .why = "a job that finds it full is done in place",
         .make = seenPlain,
         .scenes = 2,
         .settings = {"jobs=1", "split=2"}},
        {.name = "a box list of one entry",
         .why = "nodes without a box fall back to their cell",
         .make = seenPlain,
         .scenes = 2,
         .settings = {"boxes=1"}},
    };
}

}  // namespace gno::hard
