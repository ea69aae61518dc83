// SPDX-License-Identifier: MIT
// Questions "does this caster shadow this point?" on the grid, in families that are each hard in one way. The same seed gives the same questions (of
// one compiler).
#pragma once
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ostream>
#include <random>
#include <string>

#include <glm/glm.hpp>

#include "glsl/core/shared_types.h"

namespace gno::questions {

using glm::vec3;
using glm::vec4;

inline constexpr double kUnit = 0x1p-40;

struct Question {
    vec4 light;
    GnoCaster t;
    vec3 p;
};

/// The nearest multiples of 2^-40 that fp32 holds, clamped to [-1.5, 1.5].
inline float snap(double x) { return static_cast<float>(std::nearbyint(std::fmin(1.5, std::fmax(-1.5, x)) / kUnit) * kUnit); }
inline vec3 snap(glm::dvec3 v) { return {snap(v.x), snap(v.y), snap(v.z)}; }

/// Makes points of one family; the same seed gives the same points.
class Random {
public:
    explicit Random(uint64_t seed) : bits_(seed) {}

    int below(int n) { return static_cast<int>(bits_() % static_cast<uint64_t>(n)); }
    double real() { return static_cast<double>(static_cast<int64_t>(bits_() >> 11)) * 0x1p-52 - 1.0; }  // [-1, 1)
    vec3 uniform(double size = 1.0) { return snap(glm::dvec3(real(), real(), real()) * size); }
    vec3 anyExponent() { return snap(glm::dvec3(std::ldexp(real(), -below(41)), std::ldexp(real(), -below(41)), std::ldexp(real(), -below(41)))); }
    /// Coordinates in {-n .. n} * unit: many exact zeros.
    vec3 lattice(int n, double unit) { return snap(unit * glm::dvec3(below(2 * n + 1) - n, below(2 * n + 1) - n, below(2 * n + 1) - n)); }
    vec3 extreme() {
        static constexpr double kValues[] = {0.0, kUnit, 0x1p-39, 0x1p-23, 0.5, 1 - 0x1p-24, 1.0, 1 + 0x1p-23, 1 + 0x1p-10, 1.5 - 0x1p-23, 1.5};
        glm::dvec3 v;
        for (int i = 0; i < 3; ++i) {
            v[i] = kValues[below(11)] * (below(2) == 0 ? 1 : -1);
        }
        return snap(v);
    }
    /// A point of the plane through three others, up to rounding, plus -1, 0 or 1 grid unit in each coordinate.
    vec3 onPlane(vec3 a, vec3 b, vec3 c) {
        const glm::dvec3 o(a);
        return nudge(o + (glm::dvec3(b) - o) * real() + (glm::dvec3(c) - o) * real());
    }
    vec3 nudge(glm::dvec3 v) { return snap(glm::dvec3(snap(v)) + kUnit * glm::dvec3(below(3) - 1, below(3) - 1, below(3) - 1)); }
    vec3 neighbour(vec3 v) {
        for (int i = 0; i < 3; ++i) {
            v[i] = snap(std::nextafter(v[i], static_cast<float>(below(3) - 1) * 2.0f));
        }
        return v;
    }

private:
    std::mt19937_64 bits_;
};

using Maker = Question (*)(Random&);

inline vec4 light(Random& r, vec3 v) { return {v, static_cast<float>(r.below(2))}; }

struct Family {
    const char* name;
    Maker make;
};

inline void PrintTo(const Family& family, std::ostream* out) { *out << family.name; }

inline const Family kFamilies[] = {
    {"Uniform",
     [](Random& r) -> Question {
         return {light(r, r.uniform()), {r.uniform(), r.uniform(), r.uniform()}, r.uniform()};
     }},
    {"AnyExponent",
     [](Random& r) -> Question {
         return {light(r, r.anyExponent()), {r.anyExponent(), r.anyExponent(), r.anyExponent()}, r.anyExponent()};
     }},
    {"SmallestUnits",
     [](Random& r) -> Question {
         const auto v = [&] { return r.lattice(3, kUnit); };
         return {light(r, v()), {v(), v(), v()}, v()};
     }},
    {"Lattice",
     [](Random& r) -> Question {
         const auto v = [&] { return r.lattice(4, 0.25); };
         return {light(r, v()), {v(), v(), v()}, v()};
     }},
    {"LatticeNeighbours",
     [](Random& r) -> Question {
         const auto v = [&] { return r.neighbour(r.lattice(3, 0.3125)); };
         return {light(r, v()), {v(), v(), v()}, v()};
     }},
    {"Extremes",
     [](Random& r) -> Question {
         return {light(r, r.extreme()), {r.extreme(), r.extreme(), r.extreme()}, r.extreme()};
     }},
    {"PointNearCap",
     [](Random& r) -> Question {
         const GnoCaster t{r.uniform(), r.uniform(), r.uniform()};
         return {light(r, r.uniform()), t, r.onPlane(t.a, t.b, t.c)};
     }},
    {"PointNearLateral",
     [](Random& r) -> Question {
         const GnoCaster t{r.uniform(0.3), r.uniform(0.3), r.uniform(0.3)};
         const vec4 l = light(r, r.uniform(0.3));
         const vec3 e[3] = {t.a, t.b, t.c};
         const int i = r.below(3);
         const vec3 from = e[i] + vec3(l) * (1.0f - l.w);
         return {l, t, r.onPlane(e[i], e[(i + 1) % 3], l.w != 0.0f ? vec3(l) : snap(glm::dvec3(from)))};
     }},
    {"LightNearCap",
     [](Random& r) -> Question {
         const GnoCaster t{r.uniform(), r.uniform(), r.uniform()};
         const bool far = r.below(2) == 0;
         const vec3 on = r.onPlane(t.a, t.b, t.c);
         return {far ? vec4(snap(glm::dvec3(on) - glm::dvec3(t.a)), 0.0f) : vec4(on, 1.0f), t, r.uniform()};
     }},
    {"Coplanar",
     [](Random& r) -> Question {  // exactly: integer steps along two short vectors
         const glm::dvec3 o(r.lattice(7, 0.0625)), u(r.lattice(9, 0.0078125)), v(r.lattice(9, kUnit * 4096));
         const auto point = [&] { return snap(o + u * static_cast<double>(r.below(9) - 4) + v * static_cast<double>(r.below(9) - 4)); };
         const bool far = r.below(2) == 0;
         return {
             far ? vec4(r.lattice(9, 0.0078125), 0.0f) : vec4(r.below(2) == 0 ? point() : r.uniform(), 1.0f), {point(), point(), point()}, point()};
     }},
    {"Slivers",
     [](Random& r) -> Question {  // nearly or exactly collinear
         const vec3 a = r.uniform(), b = r.uniform();
         const vec3 c = r.nudge(glm::dvec3(a) + (glm::dvec3(b) - glm::dvec3(a)) * r.real());
         return {light(r, r.below(4) == 0 ? r.onPlane(a, b, c) : r.uniform()), {a, b, c}, r.below(2) == 0 ? r.onPlane(a, b, c) : r.uniform()};
     }},
    {"EqualPoints",
     [](Random& r) -> Question {
         const vec3 v[3] = {r.uniform(), r.anyExponent(), r.extreme()};
         const auto pick = [&] { return v[r.below(3)]; };
         return {light(r, pick()), {pick(), pick(), pick()}, pick()};
     }},
};

inline std::string show(const Question& q) {
    std::string text;
    const auto add = [&](const char* name, vec3 v) {
        char line[128];
        std::snprintf(line, sizeof line, "%s (%a, %a, %a)\n", name, static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z));
        text += line;
    };
    add(q.light.w != 0.0f ? "point light" : "directional light", vec3(q.light));
    add("a", q.t.a);
    add("b", q.t.b);
    add("c", q.t.c);
    add("p", q.p);
    return text;
}

}  // namespace gno::questions
