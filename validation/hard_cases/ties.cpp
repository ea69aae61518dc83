// SPDX-License-Identifier: MIT
// Samples exactly on shadow planes, shared edges and vertices, coinciding casters: signs that are zero, where every query has to agree.
#include <cmath>
#include <numbers>

#include "validation/hard_cases/hard_case.hpp"
#include "validation/hard_cases/scene_maker.hpp"

namespace gno::hard {
namespace {

constexpr double kUnit = host::cases::kUnit;
constexpr size_t kSamples = 1024;

test::Scene withSamples(glm::vec4 light, std::vector<Triangle> triangles, Random& random) {
    test::Scene scene;
    scene.light = light;
    scene.triangles = std::move(triangles);
    addHardSamples(scene, random, kSamples);
    return scene;
}

test::Scene lattice(uint32_t seed, bool directional) {
    Random random(seed);
    test::Scene scene;
    scene.triangles = host::cases::cubes(random, 10);
    scene.light = directional ? directionalLight({1, 1, 0.5}) : glm::vec4(random.lattice(8), 1);
    for (int i = 0; i < 600; ++i) addFree(scene, random.lattice(random.below(2) ? 8 : 16));
    addHardSamples(scene, random, kSamples);
    return scene;
}

test::Scene sharedEdges(uint32_t seed) {
    Random random(seed);
    return withSamples({0, 0.5f, 0, 1}, host::cases::heightField(10, random), random);
}

/// Samples on the rays through vertices and edge points, exactly (light at the origin, powers of two), and one unit or one ulp beside.
test::Scene rays(uint32_t seed, int beside) {
    Random random(seed);
    test::Scene scene;
    scene.light = {0, 0, 0, 1};
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 at = 0.25f * glm::vec3(random.inCube());
        const auto corner = [&] { return glm::vec3(snapped(glm::dvec3(at) + random.inCube(0.12))); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        scene.triangles.push_back({a, b, c});
    }
    while (scene.samples.size() < kSamples) {
        const Triangle& t = scene.triangles[random.below(60)];
        const glm::dvec3 v[3] = {t.a, t.b, t.c};
        const uint32_t i = random.below(3);
        const glm::dvec3 on = random.below(2) ? v[i] : 0.5 * (v[i] + v[(i + 1) % 3]);
        glm::vec3 p = snapped(on * (random.below(2) ? 2.0 : 1.0));
        const int axis = int(random.below(3));
        if (beside == 1) p[axis] = host::snapCoordinate(double(p[axis]) + (random.below(2) ? kUnit : -kUnit));
        if (beside == 2) p = host::cases::neighbour(p, random);
        addFree(scene, p);
    }
    return scene;
}

test::Scene diagonals(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = pointLight(glm::dvec3(0.1, 0.9, -0.05) + random.inCube(0.01));
    for (int i = 0; i < 30; ++i) {
        const glm::dvec3 o = random.inCube(0.5), u = random.inCube(0.25), v = random.inCube(0.25);
        addQuad(scene.triangles, snapped(o), snapped(o + u), snapped(o + u + v), snapped(o + v));
    }
    while (scene.samples.size() < 700) {  // behind the diagonals, which run from a to c of the first half
        const Triangle& t = scene.triangles[2 * random.below(30)];
        const glm::dvec3 q = glm::mix(glm::dvec3(t.a), glm::dvec3(t.c), random.real(0, 1));
        addFree(scene, behind(scene.light, q, random.real(0, 1)));
    }
    addHardSamples(scene, random, kSamples);
    return scene;
}

test::Scene junctions(uint32_t seed) {  // one long edge against many short ones
    Random random(seed);
    std::vector<Triangle> triangles;
    const auto height = [](int i) { return 0.25f + float(i % 3) * 0x1p-6f; };
    for (int row = 0; row < 4; ++row) {
        const float z = -0.5f + 0.25f * float(row);
        const int pieces = 1 << (2 * (row % 2) + 1);
        for (int i = 0; i < pieces; ++i) {
            const float x0 = -0.5f + float(i) / float(pieces), x1 = -0.5f + float(i + 1) / float(pieces);
            addQuad(triangles, {x0, height(row), z}, {x0, height(row + 1), z + 0.25f}, {x1, height(row + 1), z + 0.25f}, {x1, height(row), z});
        }
    }
    return withSamples(pointLight({0.0625, 0.75, 0.125}), triangles, random);
}

test::Scene duplicates(uint32_t seed) {
    Random random(seed);
    std::vector<Triangle> triangles;
    const auto corner = [&] { return snapped(random.inCube(0.6)); };
    while (triangles.size() < 20) {
        const glm::vec3 a = corner(), b = corner(), c = corner();
        triangles.push_back({a, b, c});
    }
    while (triangles.size() < 160) {  // turned and flipped
        const Triangle t = triangles[random.below(20)];
        const uint32_t kind = random.below(4);
        triangles.push_back(kind == 0 ? t : kind == 1 ? Triangle{t.b, t.c, t.a} : kind == 2 ? Triangle{t.c, t.a, t.b} : Triangle{t.a, t.c, t.b});
    }
    return withSamples(pointLight(random.inCube(0.9)), triangles, random);
}

test::Scene coplanar(uint32_t seed) {
    Random random(seed);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 120; ++i) {
        const auto corner = [&] {
            glm::vec3 v = random.lattice(16) * 0.75f;
            v.y = 0.125f;
            return v;
        };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        triangles.push_back({a, b, c});
    }
    return withSamples(pointLight({0.03, 0.7, -0.01}), triangles, random);
}

test::Scene tilted(uint32_t seed) {  // coplanar in a plane that is not an axis plane, exactly: integer combinations of two short vectors
    Random random(seed);
    std::vector<Triangle> triangles;
    const glm::vec3 u(0x1p-6f, 0x3p-8f, -0x5p-9f), v(-0x3p-9f, 0x1p-7f, 0x3p-7f);
    for (int i = 0; i < 120; ++i) {
        const auto corner = [&] { return u * float(int(random.below(33)) - 16) + v * float(int(random.below(33)) - 16); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        triangles.push_back({a, b, c});
    }
    return withSamples(directionalLight({0.3, 0.9, -0.4}), triangles, random);
}

test::Scene fan(uint32_t seed) {
    Random random(seed);
    std::vector<Triangle> triangles;
    const auto rim = [](int i) {
        const double angle = 2 * std::numbers::pi * (i % 1000) / 1000;
        return snapped({0.6 * std::cos(angle), 0.1 + 0.02 * (i % 5), 0.6 * std::sin(angle)});
    };
    for (int i = 0; i < 1000; ++i) triangles.push_back({{0, 0.25f, 0}, rim(i + 1), rim(i)});
    test::Scene scene = withSamples(pointLight({0.1, 0.8, 0.05}), triangles, random);
    for (int i = 0; i < 100; ++i) addFree(scene, behind(scene.light, {0, 0.25, 0}, 0.015 * i));
    return scene;
}

test::Scene onVertices(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.triangles = host::cases::heightField(10, random);
    addBall(scene.triangles, {0, 0.3, 0}, 0.15, 10, 6);
    scene.light = pointLight({0.2, 0.9, 0.1});
    while (scene.samples.size() < kSamples) {
        const uint32_t i = random.below(uint32_t(scene.triangles.size()));
        const glm::vec3 v[3] = {scene.triangles[i].a, scene.triangles[i].b, scene.triangles[i].c};
        const glm::vec3 p = v[random.below(3)];
        random.below(2) ? addOn(scene, i, p) : addFree(scene, p);
    }
    return scene;
}

}  // namespace

std::vector<HardCase> ties() {
    return {
        {.name = "lattice cubes, samples on the lattice",
         .why = "coinciding faces, samples exactly on shadow and capping planes",
         .make = [](uint32_t seed) { return lattice(seed, false); },
         .scenes = 3,
         .conservativeLimit = 0.002},
        {.name = "lattice cubes, diagonal light",
         .why = "the same under a direction of the lattice",
         .make = [](uint32_t seed) { return lattice(seed, true); },
         .scenes = 2,
         .conservativeLimit = 0.005},
        {.name = "a surface of shared edges",
         .why = "samples behind edges and vertices must not see light between two triangles",
         .make = sharedEdges,
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.03},
        {.name = "on the ray through a vertex or an edge",
         .why = "closed volumes: exactly on the border is in shadow",
         .make = [](uint32_t seed) { return rays(seed, 0); },
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.3},
        {.name = "one unit beside the ray",
         .why = "2^-40 beside the border, far below fp32 rounding of the products",
         .make = [](uint32_t seed) { return rays(seed, 1); },
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.3},
        {.name = "one ulp beside the ray",
         .why = "the nearest position fp32 can tell from the border",
         .make = [](uint32_t seed) { return rays(seed, 2); },
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.08},
        {.name = "diagonals of quads", .why = "a crack along the diagonal shows as a line of light", .make = diagonals, .conservativeLimit = 0.02},
        {.name = "T-junctions",
         .why = "one long edge against many short ones: no planes in common, nothing to share",
         .make = junctions,
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.02},
        {.name = "duplicates",
         .why = "every caster eight times, turned and flipped: planes equal up to the sign",
         .make = duplicates,
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.02},
        {.name = "coplanar overlaps",
         .why = "all capping planes are one: samples on it are in front of everything",
         .make = coplanar,
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.005},
        {.name = "coplanar overlaps in a tilted plane",
         .why = "the same where fp32 does not see that they are coplanar",
         .make = tilted,
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.05},
        {.name = "a fan of 1,000 triangles",
         .why = "a thousand shadow planes meet in one ray",
         .make = fan,
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.1},
        {.name = "samples on vertices",
         .why = "on up to eight casters at once, own is only one of them",
         .make = onVertices,
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.2},
    };
}

}  // namespace gno::hard
