// SPDX-License-Identifier: MIT
// Casters that go through each other: neither lies before the other, so that each ends in an intersection child of the other.
#include "validation/hard_cases/hard_case.hpp"
#include "validation/hard_cases/scene_maker.hpp"

namespace gno::hard {
namespace {

constexpr size_t kSamples = 1024;

test::Scene grass(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = seed % 2 ? pointLight({0.2, 0.95, -0.3}) : directionalLight({0.2, 1, -0.3});
    addQuad(scene.triangles, {-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1});
    for (int i = 0; i < 150; ++i)
        addBlade(scene.triangles, random, {random.real(-0.9, 0.9), 0, random.real(-0.9, 0.9)}, random.real(0, 0.1), random.real(0.05, 0.3), 0.02);
    while (scene.samples.size() < 500) {
        const uint32_t i = random.below(2);
        addOn(scene, i, pointOf(scene.triangles[i], random));
    }
    addHardSamples(scene, random, kSamples);
    return scene;
}

test::Scene crossingQuads(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = pointLight(random.inCube(0.9));
    for (int i = 0; i < 40; ++i) {
        const glm::dvec3 u = random.inCube(0.5), v = random.inCube(0.5), o = random.inCube(0.1);
        addQuad(scene.triangles, snapped(o - u - v), snapped(o + u - v), snapped(o + u + v), snapped(o - u + v));
    }
    addHardSamples(scene, random, kSamples);
    return scene;
}

test::Scene balls(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = pointLight({0.9, 0.8, 0.7});
    for (int i = 0; i < 6; ++i) addBall(scene.triangles, random.inCube(0.25), random.real(0.15, 0.3), 14, 8);
    addHardSamples(scene, random, kSamples);
    return scene;
}

test::Scene sunkBox(uint32_t seed) {  // a box whose faces lie in the planes of the floor and of each other
    Random random(seed);
    test::Scene scene;
    scene.light = pointLight({0.5, 0.75, 0.25});
    addQuad(scene.triangles, {-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1});
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 low = random.lattice(8) * 0.5f;
        addBox(scene.triangles, {low.x, -0.125f, low.z}, {low.x + 0.25f, 0.125f * float(random.below(3)), low.z + 0.25f});
    }
    addHardSamples(scene, random, kSamples);
    return scene;
}

}  // namespace

std::vector<HardCase> interpenetration() {
    return {
        {.name = "grass through a ground inserted first",
         .why = "a wedge test on the ground's capping plane would lose the blades",
         .make = grass,
         .scenes = 2,
         .first = 0,
         .conservativeLimit = 0.005},
        {.name = "crossing quads",
         .why = "forty quads through one small region: long intersection chains",
         .make = crossingQuads,
         .conservativeLimit = 0.01},
        {.name = "balls inside each other",
         .why = "surfaces in front of and behind each other in every order",
         .make = balls,
         .conservativeLimit = 0.01},
        {.name = "boxes sunk into a floor",
         .why = "interpenetration with faces that coincide",
         .make = sunkBox,
         .first = 0,
         .expectsPublishedErrors = true},
    };
}

}  // namespace gno::hard
