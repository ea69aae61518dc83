// SPDX-License-Identifier: MIT
// Small seeded scenes that are hard for a shadow test, and samples that sit where signs are zero or nearly so. No arithmetic of the oracle.
#pragma once
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "host_min/oracle.hpp"

namespace gno::host::cases {

inline constexpr float kUnit = 0x1p-40f;  // of the grid

inline float snap(double v) { return std::ldexp(std::nearbyint(std::ldexp(float(v), 40)), -40); }
inline glm::vec3 snap(glm::dvec3 v) { return {snap(v.x), snap(v.y), snap(v.z)}; }

class Random {
public:
    explicit Random(uint32_t seed) : engine_(seed) {}
    uint32_t below(uint32_t n) { return uint32_t(engine_() % n); }
    double real(double low = -1, double high = 1) { return low + (high - low) * double(engine_()) / double(engine_.max()); }
    glm::dvec3 inCube(double half = 1) { return {real(-half, half), real(-half, half), real(-half, half)}; }
    /// A point of the lattice with `cells` steps in [-1, 1].
    glm::vec3 lattice(int cells) {
        const auto one = [&] { return float(2 * int(below(uint32_t(cells + 1))) - cells) / float(cells); };
        const float x = one(), y = one(), z = one();
        return {x, y, z};
    }
    /// Any grid number: every exponent is as likely as the next, zero and one included.
    float coordinate() {
        const uint32_t kind = below(12);
        if (kind == 0) return 0.0f;
        if (kind == 1) return -0.0f;
        if (kind == 2) return below(2) ? 1.0f : -1.0f;
        if (kind == 3) return float(int(below(9)) - 4) * kUnit;
        return snap(std::ldexp(real(), -int(below(40))));
    }
    glm::vec3 position() {
        const float x = coordinate(), y = coordinate(), z = coordinate();
        return {x, y, z};
    }

private:
    std::mt19937 engine_;
};

/// v with one coordinate moved to a neighbour on the grid.
inline glm::vec3 neighbour(glm::vec3 v, Random& random) {
    const int axis = int(random.below(3));
    const float to = random.below(2) ? 2.0f : -2.0f;
    const float next = std::nextafter(v[axis], to);
    v[axis] = snap(next) == v[axis] ? v[axis] + std::copysign(kUnit, to) : snap(next);
    return v;
}

struct HardCase {
    std::string name;
    glm::vec4 light{0, 0, 0, 1};
    std::vector<Triangle> triangles;
    std::vector<uint8_t> isCaster;
    std::vector<OracleSample> samples;

    [[nodiscard]] OracleQuestion question() const { return {triangles, isCaster, light, samples}; }
};

inline bool inCube(glm::vec3 v) { return std::abs(v.x) <= 1 && std::abs(v.y) <= 1 && std::abs(v.z) <= 1; }

/// Adds samples on and behind vertices, edges and faces of the casters, their neighbours, lattice and random points, and the light itself.
inline void addSamples(HardCase& c, Random& random, size_t count) {
    const auto onTriangle = [&](const Triangle& t) -> glm::dvec3 {
        const glm::dvec3 v[3] = {t.a, t.b, t.c};
        const uint32_t i = random.below(3), kind = random.below(4);
        if (kind == 0) return v[i];
        if (kind == 1) return (v[i] + v[(i + 1) % 3]) / 2.0;
        const double s = random.real(0, 1);
        if (kind == 2) return v[i] + s * (v[(i + 1) % 3] - v[i]);
        return v[i] + s * ((v[(i + 1) % 3] - v[i]) + random.real(0, 1) * (v[(i + 2) % 3] - v[(i + 1) % 3]));
    };
    const glm::dvec3 light(c.light);
    while (c.samples.size() < count) {
        OracleSample sample{snap(random.inCube()), kNoCaster};
        const uint32_t kind = random.below(8);
        if (kind == 0) sample.position = random.lattice(8);
        if (kind == 1 && c.light.w != 0) sample.position = glm::vec3(c.light);
        if (kind >= 2 && kind < 7 && !c.triangles.empty()) {
            sample.own = random.below(uint32_t(c.triangles.size()));
            const glm::dvec3 q = onTriangle(c.triangles[sample.own]);
            const double steps[] = {0, 0, 0.25, 0.5, 1, 2, 1e-6, random.real(0, 1)};
            const double step = steps[random.below(8)];
            sample.position = snap(q + step * (c.light.w != 0 ? q - light : -light));
            if (random.below(2)) sample.own = random.below(3) ? kNoCaster : random.below(uint32_t(c.triangles.size()));
        }
        if (random.below(3) == 0) sample.position = neighbour(sample.position, random);
        if (inCube(sample.position)) c.samples.push_back(sample);
    }
}

inline void addQuad(std::vector<Triangle>& out, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
    out.push_back({a, b, c});
    out.push_back({a, c, d});
}

inline void addBox(std::vector<Triangle>& out, glm::vec3 l, glm::vec3 h) {
    addQuad(out, {l.x, l.y, l.z}, {l.x, h.y, l.z}, {h.x, h.y, l.z}, {h.x, l.y, l.z});
    addQuad(out, {l.x, l.y, h.z}, {h.x, l.y, h.z}, {h.x, h.y, h.z}, {l.x, h.y, h.z});
    addQuad(out, {l.x, l.y, l.z}, {h.x, l.y, l.z}, {h.x, l.y, h.z}, {l.x, l.y, h.z});
    addQuad(out, {l.x, h.y, l.z}, {l.x, h.y, h.z}, {h.x, h.y, h.z}, {h.x, h.y, l.z});
    addQuad(out, {l.x, l.y, l.z}, {l.x, l.y, h.z}, {l.x, h.y, h.z}, {l.x, h.y, l.z});
    addQuad(out, {h.x, l.y, l.z}, {h.x, h.y, l.z}, {h.x, h.y, h.z}, {h.x, l.y, h.z});
}

/// A height field of cells x cells quads over [-1/2, 1/2], heights multiples of 1/64: shared edges and vertices everywhere.
inline std::vector<Triangle> heightField(int cells, Random& random) {
    std::vector<glm::vec3> v;
    for (int i = 0; i <= cells; ++i) {
        for (int j = 0; j <= cells; ++j) {
            v.emplace_back(float(i) / float(cells) - 0.5f, float(random.below(8)) / 64.0f, float(j) / float(cells) - 0.5f);
        }
    }
    std::vector<Triangle> out;
    const auto at = [&](int i, int j) { return v[size_t(i * (cells + 1) + j)]; };
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) addQuad(out, at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
    }
    return out;
}

inline std::vector<Triangle> soup(size_t count, const std::function<glm::vec3()>& vertex) {
    std::vector<Triangle> out;
    while (out.size() < count) {
        const glm::vec3 a = vertex(), b = vertex(), c = vertex();
        out.push_back({a, b, c});
    }
    return out;
}

inline std::vector<Triangle> cubes(Random& random, int count) {
    std::vector<Triangle> out;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 low = random.lattice(8) * 0.5f;
        addBox(out, low, low + float(1 + random.below(3)) / 8.0f);
    }
    return out;
}

inline std::vector<Triangle> slivers(Random& random, size_t count, glm::dvec3 target) {
    std::vector<Triangle> out;
    while (out.size() < count) {  // long needles that point at the target, a few units of the grid wide
        const glm::dvec3 a = random.inCube(0.9), b = a + random.real(0.2, 0.9) * (target - a);
        out.push_back({snap(a), snap(b), snap(a + 1e-7 * random.inCube())});
    }
    return out;
}

inline glm::vec4 point(glm::vec3 p) { return {p, 1.0f}; }
inline glm::vec4 direction(glm::vec3 d) { return {d, 0.0f}; }

/// All families once. The same seed makes the same cases.
inline std::vector<HardCase> hardCases(uint32_t seed, size_t samples) {
    Random random(seed);
    std::vector<HardCase> out;
    const auto add = [&](std::string name, glm::vec4 light, std::vector<Triangle> triangles, std::vector<uint8_t> isCaster = {}) {
        HardCase c{std::move(name), light, std::move(triangles), std::move(isCaster), {}};
        addSamples(c, random, samples);
        out.push_back(std::move(c));
    };
    const auto latticePoint = [&] { return random.lattice(4); };
    const auto anyPoint = [&] { return snap(random.inCube()); };
    const auto anyCoordinates = [&] { return random.position(); };

    add("shared edges, point light over a vertex", point({0, 0.5f, 0}), heightField(6, random));
    add("shared edges, light from above", direction({0, 1, 0}), heightField(6, random));
    add("shared edges, slanted light", direction({0.5f, 1, -0.25f}), heightField(6, random));
    add("lattice cubes, lattice light", point(random.lattice(8)), cubes(random, 8));
    add("lattice cubes, slanted lattice direction", direction({1, 1, 0.5f}), cubes(random, 8));
    for (int axis = 0; axis < 3; ++axis) {
        for (const float to : {-1.0f, 1.0f}) {
            glm::vec4 light(0);
            light[axis] = to;
            add("lattice cubes, light along an axis", light, cubes(random, 4));
        }
    }
    add("lattice soup, point light", point(random.lattice(4)), soup(80, latticePoint));
    add("lattice soup, direction in a plane of the lattice", direction({1, 0, -1}), soup(80, latticePoint));
    {
        const auto triangles = soup(60, anyPoint);
        add("light on a vertex", point(triangles[random.below(60)].b), triangles);
        add("light in the middle of an edge of the lattice", point({0, 0, 0}), cubes(random, 6));
    }
    {
        std::vector<Triangle> flat = soup(40, latticePoint);
        for (size_t i = 0; i < 20; ++i) flat[i].a.y = flat[i].b.y = flat[i].c.y = 0.25f;
        add("light in the plane of casters", point({0.125f, 0.25f, -0.25f}), flat);
        add("direction in the plane of casters", direction({1, 0, 0.5f}), flat);
    }
    add("huge triangles next to the light", point(snap(random.inCube(1e-3))), soup(30, [&] { return snap(glm::sign(random.inCube())); }));
    const glm::vec3 target = snap(random.inCube(0.3));
    add("slivers that point at the light", point(target), slivers(random, 80, target));
    add("slivers, direction", direction({0.75f, -1, 0.125f}), slivers(random, 80, {0.9, -0.9, 0}));
    {
        std::vector<Triangle> room;
        addBox(room, glm::vec3(-1), glm::vec3(1));
        addBox(room, glm::vec3(-0.25f, -1, -0.25f), glm::vec3(0.25f, -0.5f, 0.25f));
        add("light inside a closed room", point(snap(random.inCube(0.4))), room);
        add("light on a wall of the room", point({1, 0.25f, -0.125f}), room);
        add("light in a corner of the room", point({-1, 1, 1}), room);
        add("light inside a box in the room", point({0.125f, -0.75f, 0}), room);
        for (Triangle& t : room) std::swap(t.b, t.c);
        add("room turned inside out", point(snap(random.inCube(0.4))), room);
    }
    {
        std::vector<Triangle> many = soup(10, anyPoint);
        while (many.size() < 100) many.push_back(many[random.below(10)]);
        add("duplicates", point(snap(random.inCube())), many);
        std::vector<uint8_t> half(many.size());
        for (uint8_t& h : half) h = uint8_t(random.below(2));
        add("some casters culled", point(snap(random.inCube())), many, half);
        add("all casters culled", point(snap(random.inCube())), many, std::vector<uint8_t>(many.size(), 0));
    }
    add("no caster", point(snap(random.inCube())), {});
    add("one caster", point(snap(random.inCube())), soup(1, anyPoint));
    add("one caster, direction", direction({-1, 0.375f, 0}), soup(1, latticePoint));
    add("numbers of every size, point light", point(random.position()), soup(100, anyCoordinates));
    add("numbers of every size, direction", direction({1, kUnit, -0.5f}), soup(100, anyCoordinates));
    add("soup, point light", point(snap(random.inCube())), soup(150, anyPoint));
    return out;
}

}  // namespace gno::host::cases
