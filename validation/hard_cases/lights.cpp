// SPDX-License-Identifier: MIT
// Lights where a plane of some caster goes through them, or nearly, and lights that see casters from very near or at a grazing angle.
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

std::vector<Triangle> soup(Random& random, size_t count, double size) {
    std::vector<Triangle> out;
    while (out.size() < count) {
        const glm::dvec3 at = random.inCube(1 - size);
        const auto corner = [&] { return snapped(at + random.inCube(size)); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        out.push_back({a, b, c});
    }
    return out;
}

/// A ground of two triangles at y, then blades and balls on it.
std::vector<Triangle> ground(Random& random, double y) {
    std::vector<Triangle> out;
    addQuad(out, snapped({-1, y, -1}), snapped({-1, y, 1}), snapped({1, y, 1}), snapped({1, y, -1}));
    for (int i = 0; i < 30; ++i) addBlade(out, random, {random.real(-0.8, 0.8), y, random.real(-0.8, 0.8)}, 0, random.real(0.01, 0.2), 0.02);
    return out;
}

test::Scene onVertex(uint32_t seed) {
    Random random(seed);
    auto triangles = host::cases::heightField(8, random);
    return withSamples({triangles[random.below(128)].b, 1}, triangles, random);
}

test::Scene onEdgeExtension(uint32_t seed) {  // heights are multiples of 1/64: the extension by one more edge is exact
    Random random(seed);
    auto triangles = host::cases::heightField(8, random);
    const Triangle& t = triangles[2 * 27];
    return withSamples({t.b + 2.0f * (t.b - t.a) + glm::vec3(0), 1}, triangles, random);
}

test::Scene inEdge(uint32_t seed) {
    Random random(seed);
    return withSamples({0, 0, 0, 1}, host::cases::cubes(random, 8), random);
}

test::Scene inPlane(uint32_t seed) {
    Random random(seed);
    std::vector<Triangle> triangles = host::cases::soup(60, [&] { return random.lattice(4); });
    for (size_t i = 0; i < 20; ++i) triangles[i].a.y = triangles[i].b.y = triangles[i].c.y = 0.25f;
    return withSamples(pointLight({0.125, 0.25, -0.25}), triangles, random);
}

test::Scene throughCasters(uint32_t seed) {
    Random random(seed);
    const glm::vec3 light = snapped(random.inCube(0.25));
    std::vector<Triangle> triangles = soup(random, 60, 0.3);
    for (int i = 0; i < 20; ++i) {  // a + b + c = 3 light, exactly: small steps around it
        const glm::vec3 u = random.lattice(16) * 0x1p-6f, v = random.lattice(16) * 0x1p-6f;
        triangles.push_back({light + u, light + v, light - (u + v)});
    }
    return withSamples({light, 1}, triangles, random);
}

test::Scene aboveGround(uint32_t seed, double height) {
    Random random(seed);
    return withSamples(pointLight({0.125, height, 0.0625}), ground(random, 0), random);
}

test::Scene aboveLongCaster(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = pointLight({-0.9, 0.5 + 3 * kUnit * 0x1p16, 0});
    addQuad(scene.triangles, snapped({-0.8, 0.5, -0.01}), snapped({-0.8, 0.5, 0.01}), snapped({0.9, 0.5, 0.01}), snapped({0.9, 0.5, -0.01}));
    for (int i = 0; i < 40; ++i) {
        const double x = random.real(-0.7, 0.9);
        addBlade(scene.triangles, random, {x, 0.5 - random.real(0, 1e-3), random.real(-0.02, 0.02)}, 1e-4, 2e-3, 1e-3);
    }
    for (int i = 0; i < 600; ++i) addOn(scene, random.below(2), pointOf(scene.triangles[random.below(2)], random));
    addHardSamples(scene, random, kSamples);
    return scene;
}

test::Scene huge(uint32_t seed, double distance) {
    Random random(seed);
    const glm::vec4 light = pointLight(random.inCube(distance));
    std::vector<Triangle> triangles;
    for (int i = 0; i < 40; ++i) {
        const auto corner = [&] { return snapped(random.inCube(1.0)); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        triangles.push_back({a, b, c});
    }
    return withSamples(light, triangles, random);
}

test::Scene wideAngle(uint32_t seed) {  // sheets close to the light on all sides, small things behind them
    Random random(seed);
    std::vector<Triangle> triangles;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-0.01, 0.012}) {
            glm::dvec3 o(0), u(0), v(0);
            o[axis] = side;
            u[(axis + 1) % 3] = 0.7 + 0.2 * random.real();
            v[(axis + 2) % 3] = 0.5 + 0.2 * random.real();
            triangles.push_back({snapped(o - u - v), snapped(o + 1.5 * u - 0.2 * v), snapped(o + 1.5 * v - 0.1 * u)});
        }
    }
    for (const Triangle& t : soup(random, 60, 0.1)) triangles.push_back(t);
    return withSamples({0, 0, 0, 1}, triangles, random);
}

test::Scene alongAxis(uint32_t seed) {
    Random random(seed);
    glm::dvec3 to(0);
    to[int(seed % 3)] = seed % 2 ? 1 : -1;
    return withSamples(directionalLight(to), host::cases::cubes(random, 12), random);
}

test::Scene alongEdge(uint32_t seed) {  // boxes sheared so that four of their edges are parallel to the light
    Random random(seed);
    const glm::vec3 to(0.5f, 1.0f, -0.25f);
    std::vector<Triangle> triangles = host::cases::cubes(random, 12);
    const auto shear = [&](glm::vec3 v) { return 0.5f * (glm::vec3(v.x, 0, v.z) + v.y * to); };
    for (Triangle& t : triangles) t = {shear(t.a), shear(t.b), shear(t.c)};
    return withSamples(directionalLight(to), triangles, random);
}

test::Scene directionInPlane(uint32_t seed) {
    Random random(seed);
    std::vector<Triangle> triangles = host::cases::soup(60, [&] { return random.lattice(4); });
    for (size_t i = 0; i < 20; ++i) triangles[i].a.y = triangles[i].b.y = triangles[i].c.y = 0.25f;
    return withSamples(directionalLight({1, 0, 0.5}), triangles, random);
}

test::Scene grazing(uint32_t seed) {
    Random random(seed);
    std::vector<Triangle> triangles = ground(random, -0.5);
    for (int i = 0; i < 60; ++i) addBlade(triangles, random, {random.real(-0.8, 0.8), -0.4, random.real(-0.8, 0.8)}, 0.05, 0.7, 0.05);
    return withSamples(directionalLight({0x1p-20, 1, -0x1p-21}), triangles, random);
}

test::Scene nearlyEdgeOn(uint32_t seed) {
    Random random(seed);
    const glm::dvec3 light = random.inCube(0.2);
    std::vector<Triangle> triangles = soup(random, 30, 0.2);
    for (int i = 0; i < 60; ++i) {  // planes that miss the light by a few units of the grid
        const glm::dvec3 a = random.inCube(0.9), b = random.inCube(0.9);
        const glm::dvec3 c = light + random.real(0.5, 2.5) * (a - light) + random.real(0.1, 0.9) * (b - light);
        if (host::cases::inCube(glm::vec3(c))) triangles.push_back({snapped(a), snapped(b), snapped(c + 3 * kUnit * random.inCube())});
    }
    return withSamples(pointLight(light), triangles, random);
}

test::Scene corner(uint32_t seed) {
    Random random(seed);
    test::Scene scene = withSamples({1, 1, 1, 1}, soup(random, 100, 0.3), random);
    for (int i = 0; i < 8; ++i) addFree(scene, {i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
    return scene;
}

}  // namespace

std::vector<HardCase> lights() {
    return {
        {.name = "light on a vertex",
         .why = "the casters around it are edge-on: their planes go through the light and mean nothing",
         .make = onVertex,
         .scenes = 2,
         .conservativeLimit = 0.01},
        {.name = "light on the extension of an edge",
         .why = "the shadow plane of that edge has no normal",
         .make = onEdgeExtension,
         .conservativeLimit = 0.02},
        {.name = "light in the middle of edges",
         .why = "lattice cubes with edges and faces through the light",
         .make = inEdge,
         .scenes = 2,
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.005},
        {.name = "light in the plane of casters",
         .why = "a third of the casters is edge-on, and others touch their plane",
         .make = inPlane,
         .conservativeLimit = 0.01},
        {.name = "casters through the light",
         .why = "the light is a point of twenty casters: distance zero, edge-on or not by rounding",
         .make = throughCasters,
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.02},
        {.name = "light one unit of the grid above the ground",
         .why = "the ground's capping plane nearly contains the light",
         .make = [](uint32_t seed) { return aboveGround(seed, kUnit); },
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.05},
        {.name = "light a hair above the ground",
         .why = "the same at 2^-24: fp32 still sees the height, the products do not",
         .make = [](uint32_t seed) { return aboveGround(seed, 0x1p-24); },
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.03},
        {.name = "light a hair above a long caster",
         .why = "small casters cross a plane that the light all but lies in",
         .make = aboveLongCaster,
         .conservativeLimit = 0.02},
        {.name = "huge casters near the light",
         .why = "the published wedge bounds vertices only: an arc between them bulges out",
         .make = [](uint32_t seed) { return huge(seed, 0.2); },
         .scenes = 2,
         .conservativeLimit = 0.002},
        {.name = "huge casters next to the light",
         .why = "the same at a thousandth of their size",
         .make = [](uint32_t seed) { return huge(seed, 1e-3); },
         .scenes = 2},
        {.name = "casters that span more than 90 degrees",
         .why = "the sum of a caster's directions is short, no cone holds it",
         .make = wideAngle,
         .expectsPublishedErrors = true},
        {.name = "light along an axis",
         .why = "lattice cubes: half of the faces is edge-on, samples on shadow planes",
         .make = alongAxis,
         .scenes = 6,
         .conservativeLimit = 0.002},
        {.name = "light along edges",
         .why = "sheared boxes whose upright edges point at the light: no shadow plane",
         .make = alongEdge,
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.08},
        {.name = "direction in the plane of casters",
         .why = "edge-on casters towards infinity",
         .make = directionInPlane,
         .conservativeLimit = 0.02},
        {.name = "casters nearly parallel to the light",
         .why = "upright blades under a light that is a millionth off the vertical",
         .make = grazing,
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.03},
        {.name = "casters nearly edge-on",
         .why = "their planes miss the light by a few units of the grid: facing is decided by the last bit",
         .make = nearlyEdgeOn,
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.1},
        {.name = "light in a corner of the grid",
         .why = "the largest coordinates and differences there are",
         .make = corner,
         .conservativeLimit = 0.05},
    };
}

}  // namespace gno::hard
