// SPDX-License-Identifier: MIT
// What a grid of cells over the directions of a light (glsl/forest) can get wrong: samples and casters on the borders of cells, on edges and corners
// of the cube, casters around the light, over exactly one cell, beside it by a corner. The directions are dyadic, so that they are exact.
#include "host_min/techniques/cell_assignment.hpp"
#include "validation/hard_cases/hard_case.hpp"
#include "validation/hard_cases/scene_maker.hpp"

namespace gno::hard {
namespace {

constexpr double kUnit = host::cases::kUnit;
constexpr size_t kSamples = 800;
const std::vector<std::string> kCells{"cells=1", "cells=4", "cells=64", "cells=256"};

/// The point of face `face` (0, 1: along x, and so on) whose direction has these places, `z` in front of the light.
glm::dvec3 onFace(glm::vec4 light, uint32_t face, double x, double y, double z) {
    glm::dvec3 q;
    const int axis = int(face / 2);
    q[axis] = face % 2 ? -z : z;
    q[(axis + 1) % 3] = x * z;
    q[(axis + 2) % 3] = y * z;
    return glm::dvec3(light) + q;
}

/// A border of one of the grids: -1, 1 and the middle more often than others.
double border(Random& random) {
    const uint32_t kind = random.below(4);
    if (kind == 0) return random.below(2) ? 1 : -1;
    if (kind == 1) return 0;
    const double cells[] = {4, 64, 256};
    const double n = cells[random.below(3)];
    return -1 + 2 * double(random.below(uint32_t(n) + 1)) / n;
}

/// Exact in fp32 with a light that is a multiple of 2^-8, times a place of at most 8 bits.
double dyadicDepth(Random& random) { return std::ldexp(double(1 + random.below(15)), -4 - int(random.below(4))); }

void addBorderSamples(test::Scene& scene, Random& random, size_t count) {
    for (size_t tries = 0; scene.samples.size() < count && tries < 20 * count; ++tries) {
        const glm::dvec3 p =
            onFace(scene.light, random.below(6), border(random), random.below(2) ? border(random) : random.real(), dyadicDepth(random));
        const glm::vec3 s = snapped(glm::clamp(p, -2.0, 2.0));
        addFree(scene, random.below(3) ? s : host::cases::neighbour(s, random));
    }
}

glm::vec4 dyadicLight(Random& random) { return {random.lattice(16) * 0.25f, 1}; }

/// A quad over the directions [x0, x1] x [y0, y1] of a face, every corner at its own distance if `uneven`.
void addOver(std::vector<Triangle>& out, Random& random, glm::vec4 light, uint32_t face, double x0, double x1, double y0, double y1, double z,
             bool uneven) {
    const auto corner = [&](double x, double y) {
        return snapped(onFace(light, face, x, y, uneven ? z * (1 + 0.25 * double(random.below(4))) : z));
    };
    const glm::vec3 a = corner(x0, y0), b = corner(x1, y0), c = corner(x1, y1), d = corner(x0, y1);
    for (const glm::vec3 v : {a, b, c, d})
        if (!host::cases::inCube(v)) return;
    host::cases::addQuad(out, a, b, c, d);
}

test::Scene onBorders(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = dyadicLight(random);
    while (scene.triangles.size() < 60) {
        const auto corner = [&] {
            return snapped(onFace(scene.light, random.below(2) + 2 * (seed % 3), border(random), border(random), dyadicDepth(random)));
        };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        if (host::cases::inCube(a) && host::cases::inCube(b) && host::cases::inCube(c)) scene.triangles.push_back({a, b, c});
    }
    addHardSamples(scene, random, kSamples / 2);
    addBorderSamples(scene, random, kSamples);
    return scene;
}

test::Scene onCubeEdges(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = dyadicLight(random);
    const auto diagonal = [&] {  // |x| = |y|, and |z| the same or less
        const double z = dyadicDepth(random), third = random.below(2) ? z : z * double(random.below(17)) / 16;
        glm::dvec3 q(random.below(2) ? z : -z, random.below(2) ? z : -z, random.below(2) ? third : -third);
        const int turn = int(random.below(3));
        return snapped(glm::clamp(glm::dvec3(scene.light) + glm::dvec3(q[turn], q[(turn + 1) % 3], q[(turn + 2) % 3]), -1.0, 1.0));
    };
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 a = diagonal();
        const auto near = [&] { return snapped(glm::clamp(glm::dvec3(a) + random.inCube(0.3), -1.0, 1.0)); };
        const glm::vec3 b = random.below(2) ? diagonal() : near(), c = near();
        scene.triangles.push_back({a, b, c});
    }
    addHardSamples(scene, random, kSamples / 2);
    while (scene.samples.size() < kSamples) {
        const glm::vec3 s = diagonal();
        addFree(scene, random.below(2) ? s : host::cases::neighbour(s, random));
    }
    return scene;
}

/// Walls in the planes between faces and between cells: through the light, so they cast nothing; boxes stand on them.
test::Scene wallsInBorderPlanes(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = {0, 0, 0, 1};
    for (int i = 0; i < 12; ++i) {
        const double z = dyadicDepth(random), far = z + 0.25, x = i % 3 ? border(random) : 1;
        const uint32_t face = random.below(6);
        const auto corner = [&](double y, double d) { return snapped(glm::clamp(onFace(scene.light, face, x, y, d), -1.0, 1.0)); };
        addQuad(scene.triangles, corner(-0.5, z), corner(0.5, z), corner(0.5, far), corner(-0.5, far));
    }
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 low = random.lattice(8) * 0.75f;  // faces in x = 0, y = 0, z = 0 and x = y among them
        addBox(scene.triangles, low, glm::min(low + 0.09375f * float(1 + random.below(2)), glm::vec3(1)));
    }
    addHardSamples(scene, random, kSamples / 2);
    addBorderSamples(scene, random, kSamples);
    return scene;
}

/// Box, needle, triangles in whose plane or on whose vertex or edge the light lies, and a soup farther out.
test::Scene aroundLight(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    const glm::vec3 l = random.lattice(16) * 0.25f;
    scene.light = {l, 1};
    addBox(scene.triangles, l - 0.0625f * float(1 + seed % 3), l + glm::vec3(0.0625f, 0.125f, 0.25f));
    scene.triangles.resize(scene.triangles.size() - 3);  // open: some of the scene sees the light
    scene.triangles.push_back({l - glm::vec3(0, 0, 0.75f), l + glm::vec3(0x1p-20f, 0, 0.5f), l + glm::vec3(-0x1p-20f, 0x1p-22f, 0.5f)});
    scene.triangles.push_back({l - glm::vec3(0.5f, 0, 0), l + glm::vec3(0.5f, 0, 0), l + glm::vec3(0, 0.25f, 0.25f)});  // on an edge
    scene.triangles.push_back({l, l + glm::vec3(0.25f, 0.125f, 0), l + glm::vec3(0, 0.25f, 0.375f)});                   // on a vertex
    scene.triangles.push_back(
        {l + glm::vec3(0.25f, 0, 0.0625f), l + glm::vec3(-0.25f, 0.25f, 0), l + glm::vec3(-0.25f, -0.25f, 0)});  // next to its face
    scene.triangles.push_back({l + glm::vec3(0.5f, 0, 0.25f), l + glm::vec3(0.25f, 0, -0.5f), l + glm::vec3(0.125f, 0, 0.125f)});  // in its plane
    for (int i = 0; i < 40; ++i) {
        const glm::dvec3 at = random.inCube(0.7);
        const auto corner = [&] { return snapped(at + random.inCube(0.25)); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        scene.triangles.push_back({a, b, c});
    }
    addHardSamples(scene, random, kSamples / 2);
    addBorderSamples(scene, random, kSamples);
    return scene;
}

/// Quads over exactly one cell of one of the grids, or over a block of cells, several behind each other.
test::Scene exactlyCells(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = dyadicLight(random);
    for (int i = 0; i < 30; ++i) {
        const double n = i % 3 == 0   ? 4
                         : i % 3 == 1 ? 64
                                      : 1,
                     x = -1 + 2 * double(random.below(uint32_t(n))) / n, y = -1 + 2 * double(random.below(uint32_t(n))) / n;
        const double wide = 2 / n * double(n > 1 && random.below(2) ? 1 + random.below(3) : 1), z = dyadicDepth(random);
        const uint32_t face = random.below(6);
        for (int layer = 0; layer < 2; ++layer)
            addOver(scene.triangles, random, scene.light, face, x, x + wide, y, y + wide, z * (1 + layer), random.below(2));
    }
    addHardSamples(scene, random, kSamples / 2);
    addBorderSamples(scene, random, kSamples);
    return scene;
}

/// Triangles that have a vertex in the direction of a cell's corner and lie in the next cell but one, and samples behind those vertices.
test::Scene touchingCorners(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = dyadicLight(random);
    std::vector<glm::vec3> corners;
    while (scene.triangles.size() < 60) {
        const double n = scene.triangles.size() % 2 ? 4 : 64, x = -1 + 2 * double(random.below(uint32_t(n) + 1)) / n,
                     y = -1 + 2 * double(random.below(uint32_t(n) + 1)) / n;
        const double z = dyadicDepth(random), sx = random.below(2) ? 1 : -1, sy = random.below(2) ? 1 : -1;
        const uint32_t face = random.below(6);
        const auto corner = [&](double dx, double dy) {
            return snapped(glm::clamp(onFace(scene.light, face, x + sx * dx / n, y + sy * dy / n, z), -1.0, 1.0));
        };
        const glm::vec3 a = corner(0, 0), b = corner(1, random.real(0, 0.5)), c = corner(random.real(0, 0.5), 1);
        corners.push_back(a);
        scene.triangles.push_back({a, b, c});
    }
    for (const glm::vec3 a : corners)
        for (const double step : {0.5, 1.0, 0x1p-20}) {
            const glm::vec3 s = snapped(glm::clamp(behind(scene.light, glm::dvec3(a), step), -2.0, 2.0));
            addFree(scene, s);
            addFree(scene, host::cases::neighbour(s, random));
        }
    addHardSamples(scene, random, kSamples);
    return scene;
}

/// Everything far away in one direction: one cell has it all.
test::Scene oneCell(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = seed % 2 ? pointLight({-0.9, -0.9, -0.9}) : directionalLight({1, 0.75, 0.5});
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 at = glm::dvec3(0.85) + random.inCube(1e-3);
        const auto corner = [&] { return snapped(at + random.inCube(1e-3)); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        scene.triangles.push_back({a, b, c});
    }
    addHardSamples(scene, random, kSamples);
    return scene;
}

/// Along an axis, or off it by a hair; the axes of the grid may be skew in fp32. Casters and samples on the borders of cells, samples outside the
/// casters' box.
test::Scene directionalGrid(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    glm::dvec3 to(0);
    to[int(seed % 3)] = seed % 2 ? 1 : -1;
    if (seed > 3) to += glm::dvec3(0x1p-20, -0x1p-22, 0x1p-24);
    if (seed > 5) to = random.inCube();
    scene.light = directionalLight(to);
    glm::vec3 low(-0.5f, -0.25f, -0.5f), high(0.5f, 0.25f, 0.5f);
    addBox(scene.triangles, low, low + 0.125f);
    addBox(scene.triangles, high - 0.125f, high);
    for (int i = 0; i < 40; ++i) {
        const uint32_t n = i % 2 ? 4 : 64;
        const GnoForestGrid grid = host::forestGrid(scene.light, low, high, n);
        const auto place = [&](float first, float step) {
            return double(first) + double(step) * (random.below(3) ? double(random.below(n + 1)) : random.real(0, n));
        };
        const auto corner = [&] {
            const glm::dvec3 p = glm::dvec3(glm::vec3(grid.across)) * place(grid.across.w, grid.stepAcross) +
                                 glm::dvec3(glm::vec3(grid.along)) * place(grid.along.w, grid.stepAlong);
            return snapped(glm::clamp(p + glm::dvec3(glm::vec3(scene.light)) * random.real(-0.25, 0.25), glm::dvec3(low), glm::dvec3(high)));
        };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        scene.triangles.push_back({a, b, c});
        const glm::dvec3 p = behind(scene.light, glm::dvec3(a), random.real(0, 0.5));
        addFree(scene, p);
        addFree(scene, host::cases::neighbour(snapped(p), random));
    }
    addHardSamples(scene, random, kSamples);
    return scene;
}

/// Walls over whole cells; behind them, what they hide; samples on, before and behind each, and where a wall ends within a cell.
test::Scene hiddenByWalls(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = seed % 2 ? dyadicLight(random) : directionalLight({0.25, 1, -0.125});
    const bool point = scene.light.w != 0;
    const glm::dvec3 l(scene.light);
    for (int i = 0; i < 4; ++i) {
        const double y = point ? l.y - 0.125 * (1 + i) : 0.5 - 0.25 * i, wide = 0.25 + 0.125 * i, tilt = i % 2 ? 0 : 0.03125;
        addQuad(scene.triangles, snapped({l.x - wide, y - tilt, l.z - wide}), snapped({l.x - wide, y - tilt, l.z + wide}),
                snapped({l.x + wide, y + tilt, l.z + wide}), snapped({l.x + wide, y + tilt, l.z - wide}));
        for (int k = 0; k < 15; ++k)
            addBlade(scene.triangles, random, {l.x + random.real(-wide, wide), y - 0.01, l.z + random.real(-wide, wide)}, 0.02, 0.05, 0.02);
    }
    for (Triangle& t : scene.triangles) t = {glm::clamp(t.a, -1.0f, 1.0f), glm::clamp(t.b, -1.0f, 1.0f), glm::clamp(t.c, -1.0f, 1.0f)};
    addHardSamples(scene, random, kSamples);
    return scene;
}

}  // namespace

std::vector<HardCase> cells() {
    std::vector<HardCase> list{{.name = "samples and casters on cell borders",
                                .why = "x/z is a border of the grid, exactly or beside it by an ulp",
                                .make = onBorders,
                                .scenes = 3,
                                .expectsPublishedErrors = true,
                                .conservativeLimit = 0.005},
                               {.name = "samples on the cube's edges and corners",
                                .why = "|x| = |y| = |z|: two or three faces of the light's cube claim them",
                                .make = onCubeEdges,
                                .conservativeLimit = 0.01},
                               {.name = "walls in the planes of cell borders",
                                .why = "geometry in the planes that cut the directions, edge-on to the light",
                                .make = wallsInBorderPlanes,
                                .conservativeLimit = 0.005},
                               {.name = "casters around the light",
                                .why = "box, needle, planes, edges and vertices through the light: no rectangle of cells",
                                .make = aroundLight,
                                .scenes = 2,
                                .conservativeLimit = 0.01},
                               {.name = "casters over exactly one cell",
                                .why = "their shadow planes are the cell's own: neither covered nor missed by sign",
                                .make = exactlyCells,
                                .scenes = 2,
                                .expectsPublishedErrors = true,
                                .conservativeLimit = 0.02},
                               {.name = "casters that touch a cell in its corner",
                                .why = "one direction in common with three cells",
                                .make = touchingCorners,
                                .expectsPublishedErrors = true,
                                .conservativeLimit = 0.15},
                               {.name = "all casters in one cell",
                                .why = "the grid is of no use, one tree has them all",
                                .make = oneCell,
                                .scenes = 2,
                                .conservativeLimit = 0.01},
                               {.name = "a directional light's grid",
                                .why = "axes that are skew in fp32, samples outside the casters' box",
                                .make = directionalGrid,
                                .scenes = 6,
                                .expectsPublishedErrors = true,
                                .conservativeLimit = 0.03},
                               {.name = "hidden by walls",
                                .why = "a caster over whole cells hides others, but not from samples before it",
                                .make = hiddenByWalls,
                                .scenes = 2,
                                .conservativeLimit = 0.02}};
    for (HardCase& hardCase : list) hardCase.choices = kCells;
    return list;
}

}  // namespace gno::hard
