// SPDX-License-Identifier: MIT
// The definition of "in shadow" (README) spelled out over __int128, with no filter and no shared code with glsl/: what tests hold modules against.
// Positions are fp32 multiples of 2^-40 with |x| <= 1.5.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>

#include <glm/glm.hpp>

namespace gno::exact {

__extension__ typedef __int128 Int128;  // NOLINT: -Wpedantic does not know __int128
using Vec = std::array<int64_t, 3>;     ///< a position or difference in units of 2^-40
using Wide = std::array<Int128, 3>;

inline Vec fixed(glm::vec3 v) {
    return {static_cast<int64_t>(std::ldexp(static_cast<double>(v.x), 40)), static_cast<int64_t>(std::ldexp(static_cast<double>(v.y), 40)),
            static_cast<int64_t>(std::ldexp(static_cast<double>(v.z), 40))};
}

inline Vec operator-(const Vec& x, const Vec& y) { return {x[0] - y[0], x[1] - y[1], x[2] - y[2]}; }

inline Wide cross(const Vec& x, const Vec& y) {
    Wide n{};
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3;
        const size_t k = (i + 2) % 3;
        n[i] = Int128{x[j]} * y[k] - Int128{x[k]} * y[j];
    }
    return n;
}

inline Int128 det(const Vec& x, const Vec& y, const Vec& z) {
    const Wide n = cross(y, z);
    return x[0] * n[0] + x[1] * n[1] + x[2] * n[2];
}

inline int sign(Int128 x) { return x < 0 ? -1 : (x > 0 ? 1 : 0); }

inline int orient3d(const Vec& o, const Vec& a, const Vec& b, const Vec& c) { return sign(det(a - o, b - o, c - o)); }

/// orient3d(light, a, b, c); a light with w = 0 is the limit of a point far away.
inline int orient3dLight(glm::vec4 light, const Vec& a, const Vec& b, const Vec& c) {
    const Vec l = fixed(glm::vec3(light));
    return light.w != 0.0f ? orient3d(l, a, b, c) : -sign(det(l, b - a, c - a));
}

/// Items 1 to 3 of the definition, for one caster (a, b, c).
inline bool inShadowOf(glm::vec4 light, const Vec& a, const Vec& b, const Vec& c, const Vec& p) {
    const Vec l = fixed(glm::vec3(light));
    const int planeToLight = light.w != 0.0f ? orient3d(a, b, c, l) : sign(det(b - a, c - a, l));
    if (planeToLight == 0) {
        return false;
    }
    const int facing = orient3dLight(light, a, b, c);
    const int lateral[3] = {orient3dLight(light, a, b, p), orient3dLight(light, b, c, p), orient3dLight(light, c, a, p)};
    for (const int side : lateral) {
        if (side != 0 && side != facing) {
            return false;
        }
    }
    return orient3d(a, b, c, p) == -planeToLight;
}

}  // namespace gno::exact
