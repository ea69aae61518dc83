// SPDX-License-Identifier: MIT
// What an engine has already: some geometry, a camera, and what each pixel sees. Plain and slow.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace hello {

struct Point {
    double at[3];
    double& operator[](int axis) { return at[axis]; }
    double operator[](int axis) const { return at[axis]; }
};
using Triangle = std::array<Point, 3>;

inline Point operator+(Point a, Point b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point operator-(Point a, Point b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point operator*(Point a, double s) { return {a[0] * s, a[1] * s, a[2] * s}; }
inline double dot(Point a, Point b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point cross(Point a, Point b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Point unit(Point a) { return a * (1 / std::sqrt(dot(a, a))); }

/// A surface over [0, 1] x [0, 1] in across x along quads.
template <class Surface>
void addSurface(std::vector<Triangle>& triangles, int across, int along, const Surface& at) {
    for (int u = 0; u < across; ++u)
        for (int v = 0; v < along; ++v) {
            const auto corner = [&](int du, int dv) {
                return at((u + du) / double(across), (v + dv) / double(along));
            };
            triangles.push_back({corner(0, 0), corner(1, 0), corner(1, 1)});
            triangles.push_back({corner(0, 0), corner(1, 1), corner(0, 1)});
        }
}

/// A hilly ground, a ring and a ball above it: some 4,000 triangles.
inline std::vector<Triangle> makeScene() {
    constexpr double turn = 6.283185307179586;
    std::vector<Triangle> triangles;
    addSurface(triangles, 24, 24, [](double u, double v) {
        return Point{10 * u - 5, 0.25 * std::sin(9 * u) * std::cos(7 * v), 10 * v - 5};
    });
    addSurface(triangles, 48, 16, [&](double u, double v) {
        const double r = 1.5 + 0.4 * std::cos(turn * v);
        return Point{r * std::cos(turn * u) - 1, 1.8 + 0.4 * std::sin(turn * v), r * std::sin(turn * u)};
    });
    addSurface(triangles, 32, 20, [&](double u, double v) {
        const double r = 0.9 * std::sin(0.5 * turn * v);
        return Point{r * std::cos(turn * u) + 1.8, 1.3 + 0.9 * std::cos(0.5 * turn * v),
                     r * std::sin(turn * u) + 0.5};
    });
    return triangles;
}

struct Hit {
    float position[3];
    std::uint32_t primitive;
};

/// The nearest triangle along a ray; its index or ~0, the place in `where`.
inline std::uint32_t firstHit(const std::vector<Triangle>& triangles, Point from, Point along, Point& where) {
    double nearest = 1e30;
    std::uint32_t found = ~0u;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const auto& [a, b, c] = triangles[i];
        const Point e = b - a, f = c - a, p = cross(along, f);
        const double determinant = dot(e, p);
        if (std::abs(determinant) < 1e-12) continue;
        const Point s = from - a, q = cross(s, e);
        const double u = dot(s, p) / determinant, v = dot(along, q) / determinant,
                     t = dot(f, q) / determinant;
        if (u < 0 || v < 0 || u + v > 1 || t < 1e-6 || t >= nearest) continue;
        nearest = t;
        found = i;
        where = from + along * t;
    }
    return found;
}

}  // namespace hello
