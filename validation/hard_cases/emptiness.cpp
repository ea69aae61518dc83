// SPDX-License-Identifier: MIT
// Nothing to insert, or next to nothing: an empty structure means lit.
#include "validation/hard_cases/hard_case.hpp"
#include "validation/hard_cases/scene_maker.hpp"

namespace gno::hard {
namespace {

constexpr size_t kSamples = 256;

test::Scene withSamples(glm::vec4 light, std::vector<Triangle> triangles, Random& random) {
    test::Scene scene;
    scene.light = light;
    scene.triangles = std::move(triangles);
    addHardSamples(scene, random, kSamples);
    return scene;
}

test::Scene none(uint32_t seed) {
    Random random(seed);
    return withSamples(seed % 2 ? pointLight({0, 0.5, 0}) : directionalLight({0, 1, 0}), {}, random);
}

test::Scene one(uint32_t seed) {
    Random random(seed);
    const auto corner = [&] { return snapped(random.inCube(0.6)); };
    const glm::vec3 a = corner(), b = corner(), c = corner();
    return withSamples(seed % 2 ? pointLight(random.inCube(0.9)) : directionalLight(random.inCube()), {{a, b, c}}, random);
}

test::Scene allCulled(uint32_t seed) {  // one face of a box: all of it looks at the light, and is said to be of a closed mesh
    Random random(seed);
    test::Scene scene;
    scene.light = pointLight({0, 0.9, 0});
    for (int i = 0; i < 16; ++i) {
        const float x = -0.5f + 0.25f * float(i % 4), z = -0.5f + 0.25f * float(i / 4);
        addQuad(scene.triangles, {x, 0, z}, {x, 0, z + 0.25f}, {x + 0.25f, 0, z + 0.25f}, {x + 0.25f, 0, z});
    }
    scene.closed.assign(scene.triangles.size(), 1);
    scene.cull = host::Cull::front;
    addHardSamples(scene, random, kSamples);
    return scene;
}

test::Scene edgeOn(uint32_t seed) {
    Random random(seed);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 30; ++i) {
        const auto corner = [&] {
            glm::vec3 v = random.lattice(8);
            v.y = 0.25f;
            return v;
        };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        triangles.push_back({a, b, c});
    }
    return withSamples(pointLight({0.375, 0.25, 0.5}), triangles, random);
}

test::Scene noArea(uint32_t seed, int good) {
    Random random(seed);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 40; ++i) {
        const glm::vec3 a = random.lattice(8), b = random.lattice(8);
        triangles.push_back(i % 3 == 0 ? Triangle{a, a, a} : i % 3 == 1 ? Triangle{a, b, a} : Triangle{a, b, 0.5f * (a + b)});
    }
    for (int i = 0; i < good; ++i) {
        const glm::vec3 a = random.lattice(8), b = random.lattice(8), c = random.lattice(8);
        triangles.insert(triangles.begin() + random.below(uint32_t(triangles.size())), Triangle{a, b, c});
    }
    return withSamples(pointLight({0.3, 0.9, -0.2}), triangles, random);
}

test::Scene atLight(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = pointLight({0.25, 0.5, -0.125});
    scene.triangles = host::cases::cubes(random, 6);
    addBox(scene.triangles, {0, 0.25f, -0.25f}, {0.25f, 0.5f, 0});
    for (int i = 0; i < 128; ++i)
        addFree(scene, i % 2 ? glm::dvec3(scene.light) : glm::dvec3(host::cases::neighbour(glm::vec3(scene.light), random)));
    addHardSamples(scene, random, kSamples);
    return scene;
}

}  // namespace

std::vector<HardCase> emptiness() {
    return {
        {.name = "no caster", .why = "an empty tree means lit", .make = none, .scenes = 2},
        {.name = "one caster", .why = "a tree of one volume: nothing routes", .make = one, .scenes = 4, .conservativeLimit = 0.15},
        {.name = "all casters culled", .why = "front-face culling leaves nothing: the tree is empty, the list is not", .make = allCulled},
        {.name = "edge-on casters only", .why = "all planes contain the light: nobody casts", .make = edgeOn},
        {.name = "casters without area only", .why = "points and lines have no planes", .make = [](uint32_t seed) { return noArea(seed, 0); }},
        {.name = "a few good casters among those without area",
         .why = "the bad ones must not disturb the tree",
         .make = [](uint32_t seed) { return noArea(seed, 10); },
         .conservativeLimit = 0.02},
        {.name = "samples at the light", .why = "no direction, no distance: and nothing shadows the light's own position", .make = atLight},
    };
}

}  // namespace gno::hard
