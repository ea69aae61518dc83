// SPDX-License-Identifier: MIT
// One large receiver and many small casters: margins that grow with the large one must not swallow the small ones.
#include "validation/hard_cases/hard_case.hpp"
#include "validation/hard_cases/scene_maker.hpp"

namespace gno::hard {
namespace {

constexpr size_t kSamples = 1024;

/// Casters of `size`, a few sizes above a receiver of two triangles at y = -0.5; samples on the receiver, most of them behind a caster.
test::Scene receiver(uint32_t seed, double size, bool directional) {
    Random random(seed);
    test::Scene scene;
    scene.light = directional ? directionalLight({0.3, 1, 0.2}) : pointLight({0.13, 0.8, -0.21});
    addQuad(scene.triangles, snapped({-1, -0.5, -1}), snapped({-1, -0.501, 1}), snapped({1, -0.5, 1}), snapped({1, -0.499, -1}));
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 at(random.real(-0.9, 0.9), -0.5 + random.real(1.5, 6) * size + 2e-3, random.real(-0.9, 0.9));
        const auto corner = [&] { return snapped(at + random.inCube(size)); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        scene.triangles.push_back({a, b, c});
    }
    const glm::dvec3 light(scene.light);
    for (int i = 0; i < 800; ++i) {
        const glm::dvec3 q = pointOf(scene.triangles[2 + random.below(200)], random), ray = directional ? -light : q - light;
        const double step = (-0.5 - q.y) / ray.y;
        addOn(scene, random.below(2), q + ray * step);
    }
    addHardSamples(scene, random, kSamples);
    return scene;
}

/// Small casters that touch a receiver from above or stick out of it by a hair.
test::Scene touching(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = pointLight({0.1, 0.9, 0.2});
    scene.triangles.push_back({{-1, 0, -1}, {-1, 0, 1}, {1, 0, 0}});
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 foot(random.real(-0.9, 0.5), 0, random.real(-0.5, 0.5));
        addBlade(scene.triangles, random, foot, random.below(2) ? 0.0 : 1e-7 * random.real(0, 1), 1e-3, 1e-4);
    }
    for (int i = 0; i < 600; ++i) addOn(scene, 0, pointOf(scene.triangles[1 + random.below(400)], random) * glm::dvec3(1, 0, 1));
    addHardSamples(scene, random, kSamples);
    return scene;
}

/// A wall that hides everything, and casters within its volume: they are dropped, and must not be missed.
test::Scene hidden(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = pointLight({0, 0.95, 0});
    scene.triangles.push_back({snapped({-0.9, 0.5, -0.8}), snapped({0.9, 0.5, -0.8}), snapped({0, 0.5, 0.9})});
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 at(random.real(-0.6, 0.6), random.real(0.3, 0.55), random.real(-0.6, 0.6));
        const auto corner = [&] { return snapped(at + random.inCube(0.03)); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        scene.triangles.push_back({a, b, c});
    }
    addSurfaceSamples(scene, random, 500);
    addHardSamples(scene, random, kSamples);
    return scene;
}

}  // namespace

std::vector<HardCase> bigAndSmall() {
    return {
        {.name = "a large receiver inserted first",
         .why = "most samples lie in its capping plane's band, with casters above that belong to its positive child",
         .make = [](uint32_t seed) { return receiver(seed, 0.02, false); },
         .scenes = 2,
         .first = 0,
         .conservativeLimit = 0.005},
        {.name = "a large receiver, tiny casters",
         .why = "casters of a ten-thousandth of its size, hardly above its band",
         .make = [](uint32_t seed) { return receiver(seed, 1e-4, false); },
         .first = 0},
        {.name = "a large receiver, directional light",
         .why = "the band is absolute there",
         .make = [](uint32_t seed) { return receiver(seed, 1e-3, true); },
         .first = 0,
         .conservativeLimit = 0.002},
        {.name = "small casters that touch a large one",
         .why = "they start on its plane, or a hair below",
         .make = touching,
         .first = 0,
         .conservativeLimit = 0.01},
        {.name = "a wall in front of everything",
         .why = "casters inside its volume are dropped, those that stick out are not",
         .make = hidden,
         .first = 0,
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.02},
    };
}

}  // namespace gno::hard
