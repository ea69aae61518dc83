// SPDX-License-Identifier: MIT
// Scenes far from the origin, very small ones, and numbers of every size. World positions go onto the grid as a loaded scene's do.
#include "host_min/scene/grid.hpp"
#include "validation/hard_cases/hard_case.hpp"
#include "validation/hard_cases/scene_maker.hpp"

namespace gno::hard {
namespace {

constexpr size_t kSamples = 1024;

/// A small town around `centre`, boxes and blades of a few `unit`s on a ground of 40 x 40 units; the light stands 15 units above it.
test::Scene town(uint32_t seed, glm::dvec3 centre, double unit) {
    Random random(seed);
    const host::Grid grid = host::Grid::around(centre - 20 * unit, centre + 20 * unit);
    const auto at = [&](double x, double y, double z) { return grid.snap(centre + unit * glm::dvec3(x, y, z)); };
    test::Scene scene;
    scene.light = {at(3, 15, -2), 1};
    addQuad(scene.triangles, at(-20, 0, -20), at(-20, 0, 20), at(20, 0, 20), at(20, 0, -20));
    for (int i = 0; i < 25; ++i) {
        const int x = int(random.below(30)) - 15, z = int(random.below(30)) - 15, h = 1 + int(random.below(6));
        addBox(scene.triangles, at(x, 0, z), at(x + 1 + int(random.below(3)), h, z + 1 + int(random.below(3))));
    }
    addHardSamples(scene, random, kSamples);
    return scene;
}

/// Everything within a ball of 2^-k of the grid, somewhere in it, light included.
test::Scene tiny(uint32_t seed, glm::dvec3 at, double size) {
    Random random(seed);
    test::Scene scene;
    scene.light = pointLight(at + size * glm::dvec3(0.25, 1, -0.125));
    for (int i = 0; i < 80; ++i) {
        const auto corner = [&] { return snapped(at + random.inCube(size)); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        scene.triangles.push_back({a, b, c});
    }
    while (scene.samples.size() < 600) addFree(scene, at + random.inCube(size));
    addHardSamples(scene, random, kSamples);
    return scene;
}

test::Scene everySize(uint32_t seed, bool directional) {
    Random random(seed);
    test::Scene scene;
    scene.light = directional ? directionalLight({1, host::cases::kUnit, -0.5}) : glm::vec4(random.position(), 1);
    scene.triangles = host::cases::soup(120, [&] { return random.position(); });
    while (scene.samples.size() < 400) addFree(scene, random.position());
    addHardSamples(scene, random, kSamples);
    return scene;
}

test::Scene corners(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = {0.25f, 0.5f, -0.125f, 1};
    scene.triangles = host::cases::soup(60, [&] {
        return glm::vec3(random.below(2) ? 1 : -1, random.below(2) ? 1 : -1, random.below(2) ? 1 : -1) * (random.below(3) ? 1.0f : 0.5f);
    });
    for (int i = 0; i < 8; ++i) addFree(scene, {i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
    addHardSamples(scene, random, kSamples);
    return scene;
}

/// Casters of a few units of the grid near the light, the receiver at the other end.
test::Scene dustAtLight(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    const glm::dvec3 light(0.5, 0.5, 0.5);
    scene.light = pointLight(light);
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 at = light - 1e-5 * glm::dvec3(random.real(0.5, 1), random.real(0.5, 1), random.real(0.5, 1));
        const auto corner = [&] { return snapped(at + 1e-6 * random.inCube()); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        scene.triangles.push_back({a, b, c});
    }
    while (scene.samples.size() < 700) {
        const glm::dvec3 q = pointOf(scene.triangles[random.below(100)], random);
        addFree(scene, light + (q - light) * random.real(1, 8e4));
    }
    addHardSamples(scene, random, kSamples);
    return scene;
}

}  // namespace

std::vector<HardCase> scale() {
    return {
        {.name = "coordinates of ten million",
         .why = "a town with detail of one unit, 10^7 units from the origin: fp32 world space holds no half units there",
         .make =
             [](uint32_t seed) {
                 return town(seed, {1e7, -1.3e7, 6e6}, 1);
             },
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.002},
        {.name = "a town of a ten-thousandth",
         .why = "10^-4 units in all, off the origin: an absolute bias would be larger than the scene",
         .make =
             [](uint32_t seed) {
                 return town(seed, {0.7, -0.2, 0.1}, 2.5e-6);
             },
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.002},
        {.name = "a tiny scene in a corner of the grid",
         .why = "2^-16 wide, where positions have few bits left",
         .make =
             [](uint32_t seed) {
                 return tiny(seed, {-0.9, 0.9, 0.9}, 0x1p-16);
             }},
        {.name = "a scene of 64 units of the grid",
         .why = "2^-34 wide about the origin: cross products of 2^-68",
         .make =
             [](uint32_t seed) {
                 return tiny(seed, {0, 0, 0}, 0x1p-34);
             }},
        {.name = "numbers of every size",
         .why = "every exponent from 2^-40 to 1 in one triangle",
         .make = [](uint32_t seed) { return everySize(seed, false); },
         .scenes = 2,
         .conservativeLimit = 0.005},
        {.name = "numbers of every size, directional light",
         .why = "a direction of one unit of the grid in one component",
         .make = [](uint32_t seed) { return everySize(seed, true); },
         .conservativeLimit = 0.02},
        {.name = "corners of the grid",
         .why = "the largest triangles there are, samples in the corners",
         .make = corners,
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.002},
        {.name = "dust next to the light",
         .why = "casters of a millionth whose shadows fill the scene",
         .make = dustAtLight,
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.1},
    };
}

}  // namespace gno::hard
