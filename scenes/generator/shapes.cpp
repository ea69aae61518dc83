// SPDX-License-Identifier: MIT
#include "scenes/generator/shapes.hpp"

#include <algorithm>
#include <cmath>

#include "scenes/generator/numbers.hpp"

namespace gno::scenes {

void addBox(Mesh& mesh, const glm::dvec3& low, const glm::dvec3& high) {
    uint32_t v[8];
    for (uint32_t i = 0; i < 8; ++i) v[i] = mesh.vertex({(i & 1) ? high.x : low.x, (i & 2) ? high.y : low.y, (i & 4) ? high.z : low.z});
    mesh.quad(v[0], v[2], v[3], v[1]);
    mesh.quad(v[4], v[5], v[7], v[6]);
    mesh.quad(v[0], v[4], v[6], v[2]);
    mesh.quad(v[1], v[3], v[7], v[5]);
    mesh.quad(v[0], v[1], v[5], v[4]);
    mesh.quad(v[2], v[6], v[7], v[3]);
}

void addBox(Mesh& mesh, const glm::dvec3& centre, const glm::dvec3& size, const glm::dquat& rotation) {
    Mesh box;
    addBox(box, -size / 2.0, size / 2.0);
    mesh.append(box, at(centre, rotation));
}

void addPrism(Mesh& mesh, const std::vector<glm::dvec2>& polygon, double low, double high) {
    const auto n = static_cast<uint32_t>(polygon.size());
    const auto base = static_cast<uint32_t>(mesh.positions.size());
    for (const glm::dvec2& p : polygon) mesh.vertex({p.x, low, p.y});
    for (const glm::dvec2& p : polygon) mesh.vertex({p.x, high, p.y});
    for (uint32_t i = 0; i < n; ++i) {
        const uint32_t j = (i + 1) % n;
        mesh.quad(base + i, base + n + i, base + n + j, base + j);
    }
    for (uint32_t i = 1; i + 1 < n; ++i) {
        mesh.triangle(base, base + i, base + i + 1);
        mesh.triangle(base + n, base + n + i + 1, base + n + i);
    }
}

void addGable(Mesh& mesh, const glm::dvec3& low, const glm::dvec3& high) {
    const double middle = (low.x + high.x) / 2;
    const uint32_t a = mesh.vertex({low.x, low.y, low.z});
    const uint32_t b = mesh.vertex({high.x, low.y, low.z});
    const uint32_t c = mesh.vertex({middle, high.y, low.z});
    const uint32_t d = mesh.vertex({low.x, low.y, high.z});
    const uint32_t e = mesh.vertex({high.x, low.y, high.z});
    const uint32_t f = mesh.vertex({middle, high.y, high.z});
    mesh.triangle(a, c, b);
    mesh.triangle(d, e, f);
    mesh.quad(a, b, e, d);
    mesh.quad(a, d, f, c);
    mesh.quad(b, c, f, e);
}

void addLathe(Mesh& mesh, const std::vector<glm::dvec2>& profile, int sides, const Placement& placement) {
    const auto n = static_cast<uint32_t>(sides);
    const bool mirrored = glm::determinant(placement.linear) < 0;
    auto triangle = [&](uint32_t a, uint32_t b, uint32_t c) { mirrored ? mesh.triangle(a, c, b) : mesh.triangle(a, b, c); };
    const uint32_t bottom = mesh.vertex(placement({0, profile.front().y, 0}));
    const uint32_t top = mesh.vertex(placement({0, profile.back().y, 0}));
    const auto rings = static_cast<uint32_t>(profile.size() - 2);
    const auto base = static_cast<uint32_t>(mesh.positions.size());
    for (uint32_t r = 0; r < rings; ++r)
        for (uint32_t i = 0; i < n; ++i) {
            const double angle = 2 * kPi * i / n;
            const glm::dvec2 p = profile[r + 1];
            mesh.vertex(placement({p.x * cosine(angle), p.y, -p.x * sine(angle)}));
        }
    for (uint32_t i = 0; i < n; ++i) {
        const uint32_t j = (i + 1) % n;
        triangle(bottom, base + j, base + i);
        for (uint32_t r = 0; r + 1 < rings; ++r) {
            const uint32_t a = base + r * n + i;
            const uint32_t b = base + r * n + j;
            triangle(a, b, b + n);
            triangle(a, b + n, a + n);
        }
        triangle(top, base + (rings - 1) * n + i, base + (rings - 1) * n + j);
    }
}

void addCylinder(Mesh& mesh, const glm::dvec3& foot, const glm::dvec3& head, double footRadius, double headRadius, int sides) {
    addTaperedTube(mesh, {foot, head}, footRadius, headRadius, sides);
}

void addBall(Mesh& mesh, const glm::dvec3& centre, const glm::dvec3& radii, int sides) {
    const int rings = std::max(2, sides / 2);
    std::vector<glm::dvec2> profile;
    for (int r = 0; r <= rings; ++r) {
        const double angle = kPi * r / rings - kPi / 2;
        profile.emplace_back(cosine(angle), sine(angle));
    }
    addLathe(mesh, profile, std::max(3, sides), at(centre, glm::dquat(1, 0, 0, 0), radii));
}

namespace {

// Two unit vectors across each point of a path, carried along so that they turn as little as possible.
struct Across {
    std::vector<glm::dvec3> u, v;

    Across(const Path& path, bool ring, const glm::dvec3& first) {
        const size_t n = path.size();
        glm::dvec3 side = first;
        for (size_t i = 0; i < n; ++i) {
            const glm::dvec3& before = path[i > 0 ? i - 1 : (ring ? n - 1 : 0)];
            const glm::dvec3& after = path[i + 1 < n ? i + 1 : (ring ? 0 : n - 1)];
            const glm::dvec3 along = glm::normalize(after - before);
            side = glm::normalize(side - along * glm::dot(side, along));
            u.push_back(side);
            v.push_back(glm::cross(along, side));
        }
    }
};

glm::dvec3 anyAcross(const glm::dvec3& along) { return std::abs(along.y) < 0.9 * glm::length(along) ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0); }

void tube(Mesh& mesh, const Path& path, double first, double last, int sides, bool ring) {
    const auto points = static_cast<uint32_t>(path.size());
    const auto n = static_cast<uint32_t>(sides);
    // A ring lies about in a plane: its normal is never along the path.
    const glm::dvec3 start = ring ? glm::normalize(glm::cross(path[1] - path[0], path[points / 2] - path[0])) : anyAcross(path[1] - path[0]);
    const Across across(path, ring, start);
    const auto base = static_cast<uint32_t>(mesh.positions.size());
    for (uint32_t i = 0; i < points; ++i) {
        const double radius = first + (last - first) * i / std::max(1u, points - 1);
        for (uint32_t k = 0; k < n; ++k) {
            const double angle = 2 * kPi * k / n;
            mesh.vertex(path[i] + radius * (cosine(angle) * across.u[i] + sine(angle) * across.v[i]));
        }
    }
    const uint32_t spans = ring ? points : points - 1;
    for (uint32_t i = 0; i < spans; ++i)
        for (uint32_t k = 0; k < n; ++k) {
            const uint32_t next = ((i + 1) % points) * n;
            const uint32_t l = (k + 1) % n;
            mesh.quad(base + i * n + k, base + i * n + l, base + next + l, base + next + k);
        }
    if (ring) return;
    const uint32_t end = base + (points - 1) * n;
    for (uint32_t k = 1; k + 1 < n; ++k) {
        mesh.triangle(base, base + k + 1, base + k);
        mesh.triangle(end, end + k, end + k + 1);
    }
}

}  // namespace

void addTube(Mesh& mesh, const Path& path, double radius, int sides, bool ring) { tube(mesh, path, radius, radius, sides, ring); }

void addTaperedTube(Mesh& mesh, const Path& path, double first, double last, int sides) { tube(mesh, path, first, last, sides, false); }

void addGutter(Mesh& mesh, const Path& path, double radius, double thickness, int sides) {
    const auto points = static_cast<uint32_t>(path.size());
    const auto n = static_cast<uint32_t>(sides) + 1;
    const Across across(path, false, {0, 1, 0});
    const auto base = static_cast<uint32_t>(mesh.positions.size());
    const uint32_t row = 2 * n;  // a cross-section: n outer vertices from left to right, then n inner ones from right to left
    for (uint32_t i = 0; i < points; ++i)
        for (uint32_t k = 0; k < row; ++k) {
            const bool outer = k < n;
            const double angle = kPi * (outer ? k : row - 1 - k) / (n - 1);
            const double r = outer ? radius + thickness : radius;
            mesh.vertex(path[i] + r * (cosine(angle) * across.v[i] - sine(angle) * across.u[i]));
        }
    for (uint32_t i = 0; i + 1 < points; ++i)
        for (uint32_t k = 0; k < row; ++k) {
            const uint32_t a = base + i * row;
            const uint32_t l = (k + 1) % row;
            mesh.quad(a + k, a + l, a + row + l, a + row + k);
        }
    const uint32_t end = base + (points - 1) * row;
    for (uint32_t k = 0; k + 1 < n; ++k) {
        const uint32_t inner = row - 1 - k;
        mesh.quad(base + k, base + inner, base + inner - 1, base + k + 1);
        mesh.quad(end + k, end + k + 1, end + inner - 1, end + inner);
    }
}

void addLeaf(Mesh& mesh, const glm::dvec3& stem, const glm::dvec3& along, const glm::dvec3& up, double width) {
    const glm::dvec3 side = glm::normalize(glm::cross(along, up)) * (width / 2);
    const glm::dvec3 lift = glm::normalize(glm::cross(side, along)) * (width * 0.35);
    const uint32_t a = mesh.vertex(stem);
    const uint32_t b = mesh.vertex(stem + along * 0.45 + side + lift);
    const uint32_t c = mesh.vertex(stem + along);
    const uint32_t d = mesh.vertex(stem + along * 0.45 - side + lift);
    mesh.triangle(a, b, d);
    mesh.triangle(b, c, d);
    mesh.triangle(a, c, b);
    mesh.triangle(a, d, c);
}

void addBlade(Mesh& mesh, const glm::dvec3& root, const glm::dvec3& growth, const glm::dvec3& side, const glm::dvec3& bend, double width,
              int parts) {
    uint32_t left = mesh.vertex(root - side * (width / 2));
    uint32_t right = mesh.vertex(root + side * (width / 2));
    for (int i = 1; i <= parts; ++i) {
        const double t = static_cast<double>(i) / parts;
        const glm::dvec3 centre = root + growth * t + bend * (t * t);
        if (i == parts) {
            mesh.triangle(left, right, mesh.vertex(centre));
            return;
        }
        const double half = width / 2 * (1 - 0.6 * t);
        const uint32_t l = mesh.vertex(centre - side * half);
        const uint32_t r = mesh.vertex(centre + side * half);
        mesh.quad(left, right, r, l);
        left = l;
        right = r;
    }
}

Path hangingPath(const glm::dvec3& a, const glm::dvec3& b, double sag, int count) {
    Path path;
    for (int i = 0; i <= count; ++i) {
        const double t = static_cast<double>(i) / count;
        path.push_back(a + (b - a) * t - glm::dvec3(0, sag * 4 * t * (1 - t), 0));
    }
    return path;
}

Path arcPath(const glm::dvec3& centre, const glm::dvec3& u, const glm::dvec3& v, double from, double sweep, int count) {
    Path path;
    const bool whole = std::abs(sweep) > 2 * kPi - 1e-9;
    for (int i = 0; i < count; ++i) {
        const double angle = from + sweep * i / (whole ? count : count - 1);
        path.push_back(centre + cosine(angle) * u + sine(angle) * v);
    }
    return path;
}

}  // namespace gno::scenes
