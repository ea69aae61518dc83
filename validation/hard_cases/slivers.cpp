// SPDX-License-Identifier: MIT
// Triangles with next to no area: their planes are mostly rounding, and so is every distance to them.
#include "validation/hard_cases/hard_case.hpp"
#include "validation/hard_cases/scene_maker.hpp"

namespace gno::hard {
namespace {

constexpr double kUnit = host::cases::kUnit;
constexpr size_t kSamples = 1024;

std::vector<Triangle> thin(Random& random, size_t count, double width) {
    std::vector<Triangle> out;
    while (out.size() < count) {
        const glm::dvec3 a = random.inCube(0.9), b = random.inCube(0.9);
        out.push_back({snapped(a), snapped(b), snapped(glm::mix(a, b, random.real(0, 1)) + width * random.inCube())});
    }
    return out;
}

test::Scene withSamples(glm::vec4 light, std::vector<Triangle> triangles, Random& random) {
    test::Scene scene;
    scene.light = light;
    scene.triangles = std::move(triangles);
    addHardSamples(scene, random, kSamples);
    return scene;
}

test::Scene thinTriangles(uint32_t seed, double width) {
    Random random(seed);
    const glm::dvec3 light = random.inCube();
    return withSamples(pointLight(light), thin(random, 120, width), random);
}

test::Scene needles(uint32_t seed) {
    Random random(seed);
    const glm::vec3 light = snapped(random.inCube(0.3));
    return withSamples({light, 1}, host::cases::slivers(random, 120, light), random);
}

test::Scene directionalNeedles(uint32_t seed) {
    Random random(seed);
    const glm::dvec3 to(0.75, 1, 0.125);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 120; ++i) {
        const glm::dvec3 a = random.inCube(0.5);
        triangles.push_back({snapped(a), snapped(a + random.real(0.1, 0.4) * to), snapped(a + 1e-7 * random.inCube())});
    }
    return withSamples(directionalLight(to), triangles, random);
}

test::Scene ribbon(uint32_t seed) {  // a surface of slivers: every long edge is shared
    Random random(seed);
    std::vector<Triangle> triangles;
    const auto at = [](int i, bool far) { return snapped({-0.5 + i * 1e-5, 0.2 + 1e-6 * (i % 7), far ? 0.9 : -0.9}); };
    for (int i = 0; i < 150; ++i) addQuad(triangles, at(i, false), at(i, true), at(i + 1, true), at(i + 1, false));
    return withSamples(pointLight({-0.4993, 0.9, 0.01}), triangles, random);
}

test::Scene hairAndFloor(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = pointLight({0.3, 0.9, -0.2});
    addQuad(scene.triangles, {-1, -0.5f, -1}, {-1, -0.5f, 1}, {1, -0.5f, 1}, {1, -0.5f, -1});
    for (const Triangle& t : thin(random, 100, 1e-6)) scene.triangles.push_back(t);
    for (int i = 0; i < 500; ++i) {
        const Triangle& t = scene.triangles[2 + random.below(100)];
        const glm::dvec3 q = pointOf(t, random), ray = q - glm::dvec3(scene.light);
        if (ray.y < 0) addOn(scene, random.below(2), q + ray * ((-0.5 - q.y) / ray.y));
    }
    addHardSamples(scene, random, kSamples);
    return scene;
}

}  // namespace

std::vector<HardCase> slivers() {
    return {
        {.name = "slivers",
         .why = "a millionth wide: normals of few good bits",
         .make = [](uint32_t seed) { return thinTriangles(seed, 1e-6); },
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.2},
        {.name = "slivers one unit of the grid wide",
         .why = "the thinnest triangles that have an area, and some without",
         .make = [](uint32_t seed) { return thinTriangles(seed, kUnit); },
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.1},
        {.name = "needles towards the light",
         .why = "thin, and seen end-on: neither a plane nor a distance is good",
         .make = needles,
         .expectsPublishedErrors = true,
         .conservativeLimit = 1},
        {.name = "needles towards a directional light",
         .why = "the same towards infinity",
         .make = directionalNeedles,
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.4},
        {.name = "a ribbon of slivers",
         .why = "every long edge is shared: a leak between two of them is a line of light",
         .make = ribbon,
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.005},
        {.name = "hair over a floor",
         .why = "samples on the floor exactly behind the hair, floor and hair in one tree",
         .make = hairAndFloor,
         .first = 0,
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.15},
    };
}

}  // namespace gno::hard
