// SPDX-License-Identifier: MIT
// What the scenes of cases.cpp are made of: lights, soups, grids and samples that sit where signs are zero or nearly so. No arithmetic of the
// modules.
#pragma once
#include <cmath>

#include "validation/support/grid_questions.hpp"
#include "validation/support/top_on_cpu_check.hpp"

namespace gno::mutants {

using cpu::TinyScene;
using glm::dvec3;
using questions::Random;
using questions::snap;

inline bool inScene(vec3 v) { return std::abs(v.x) <= 1 && std::abs(v.y) <= 1 && std::abs(v.z) <= 1; }

/// A direction towards the light in its own grid: largest component in [0.5, 1].
inline vec4 directional(dvec3 towards) {
    const double largest = std::fmax(std::fabs(towards.x), std::fmax(std::fabs(towards.y), std::fabs(towards.z)));
    int exponent = 0;
    std::frexp(largest, &exponent);
    return vec4(snap(towards * std::ldexp(1.0, -exponent)), 0.0f);
}

inline vec4 anyLight(Random& r) {
    if (r.below(2) == 0) return vec4(r.uniform(), 1.0f);
    dvec3 towards(0);
    while (glm::length(towards) < 0.1) towards = dvec3(r.real(), r.real(), r.real());
    return directional(towards);
}

inline vec4 latticeLight(Random& r) {
    const vec3 at = r.lattice(4, 0.25);
    return r.below(2) == 0 || at == vec3(0) ? vec4(at, 1.0f) : directional(at);
}

/// The point behind x, seen from the light: k = 1 is x itself, k = 2 as far again (directional: half a scene away).
inline dvec3 behind(vec4 light, dvec3 x, double k) {
    const dvec3 l(light);
    return light.w != 0.0f ? l + (x - l) * k : x - l * (0.5 * (k - 1.0));
}

inline dvec3 onCaster(Random& r, const GnoCaster& t) {
    const dvec3 v[3] = {t.a, t.b, t.c};
    const int i = r.below(3);
    const dvec3 &a = v[i], &b = v[(i + 1) % 3], &c = v[(i + 2) % 3];
    const double s = r.real() * 0.5 + 0.5, u = r.real() * 0.5 + 0.5;
    switch (r.below(4)) {
        case 0:
            return a;
        case 1:
            return (a + b) * 0.5;
        case 2:
            return a + (b - a) * s;
        default:
            return a + (b - a) * s + (c - b) * (s * u);
    }
}

inline void addSample(TinyScene& scene, vec3 p) {
    if (inScene(p)) scene.samples.push_back({p, GNO_NO_CASTER});
}

/// Samples on the ray through a vertex, an edge or the inside of a caster, a few of them a unit or an ulp beside it.
inline void addBehind(Random& r, TinyScene& scene, const GnoCaster& t, int count) {
    for (int i = 0; i < count; ++i) {
        const double k = r.below(4) == 0 ? 1.0 + std::ldexp(1.0, -r.below(26)) : r.below(3) == 0 ? 2.0 : 1.0 + 1.5 * (r.real() + 1.0);
        vec3 p = snap(behind(scene.light, onCaster(r, t), k));
        if (r.below(4) == 0) p = r.neighbour(p);
        addSample(scene, p);
    }
}

/// View samples of caster i as a renderer makes them: on it, moved along its normal until they are strictly on the light's side.
inline void addOwn(Random& r, TinyScene& scene, uint i, int count) {
    const GnoCaster& t = scene.casters[i];
    dvec3 n = glm::cross(dvec3(t.b) - dvec3(t.a), dvec3(t.c) - dvec3(t.a));
    if (glm::length(n) == 0.0) return;
    n = glm::normalize(n);
    const dvec3 toLight = dvec3(vec3(scene.light)) - dvec3(t.a) * double(scene.light.w);
    if (glm::dot(n, toLight) < 0.0) n = -n;
    for (int k = 0; k < count; ++k) {
        const dvec3 on = onCaster(r, t);
        for (double step = 0x1p-40; step < 0x1p-10; step *= 2.0) {
            const vec3 p = snap(on + n * step);
            if (!cpu::strictlyInFront(t, scene.light, p)) continue;
            if (inScene(p)) scene.samples.push_back({p, i});
            break;
        }
    }
}

inline void addEverywhere(Random& r, TinyScene& scene, int count) {
    for (int i = 0; i < count && !scene.casters.empty(); ++i) {
        const uint c = uint(r.below(int(scene.casters.size())));
        switch (r.below(6)) {
            case 0:
                addSample(scene, r.uniform());
                break;
            case 1:
                addSample(scene, r.lattice(4, 0.25));
                break;
            case 2:
                addOwn(r, scene, c, 1);
                break;
            case 3:
                addSample(scene, snap(onCaster(r, scene.casters[c])));
                break;
            default:
                addBehind(r, scene, scene.casters[c], 1);
        }
    }
}

/// A height field of `cells` x `cells` squares over [-size, size]^2, two triangles each, around height y.
inline void addField(Random& r, TinyScene& scene, int cells, double size, double y, double height) {
    std::vector<vec3> points;
    for (int i = 0; i <= cells; ++i) {
        for (int j = 0; j <= cells; ++j) {
            points.push_back(snap(dvec3(size * (2.0 * i / cells - 1.0), y + height * (r.below(5) - 2) * 0.25, size * (2.0 * j / cells - 1.0))));
        }
    }
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            const size_t at = size_t(i * (cells + 1) + j), next = at + size_t(cells) + 1;
            scene.casters.push_back({points[at], points[next], points[at + 1]});
            scene.casters.push_back({points[next], points[next + 1], points[at + 1]});
        }
    }
}

inline void addBox(TinyScene& scene, dvec3 low, dvec3 high) {
    static constexpr int kFaces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                          {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    const auto corner = [&](int i) { return snap(dvec3((i & 1) ? high.x : low.x, (i & 2) ? high.y : low.y, (i & 4) ? high.z : low.z)); };
    for (const auto& f : kFaces) scene.casters.push_back({corner(f[0]), corner(f[1]), corner(f[2])});
}

}  // namespace gno::mutants
