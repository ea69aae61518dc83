// SPDX-License-Identifier: MIT
#include "host_min/frame/cull_hull.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace gno::host {
namespace {

using glm::dvec3;
using glm::dvec4;

/// The frustum as points and directions (w = 0), its faces as planes (inside >= 0), and its edges as pairs of corners with the two faces they part.
struct Frustum {
    std::vector<dvec4> corners;
    std::vector<dvec4> faces;
    struct Edge {
        size_t corner[2];
        size_t face[2];
    };
    std::vector<Edge> edges;
};

double at(dvec4 plane, dvec4 p) { return glm::dot(dvec3(plane), dvec3(p)) + plane.w * p.w; }

std::optional<dvec4> planeThrough(dvec4 p, dvec4 q, dvec4 r) {  // at least one of them is a point
    const dvec4* base = p.w != 0 ? &p : q.w != 0 ? &q : &r;
    const auto from = [&](const dvec4& x) { return x.w != 0 ? dvec3(x) - dvec3(*base) : dvec3(x); };
    std::array<dvec3, 2> spans{};
    size_t count = 0;
    for (const dvec4* x : {&p, &q, &r})
        if (x != base) spans[count++] = from(*x);
    const double scale = glm::length(spans[0]) * glm::length(spans[1]);
    const dvec3 normal = glm::cross(spans[0], spans[1]);
    if (!(glm::length(normal) > 1e-9 * scale)) return std::nullopt;
    const dvec3 unit = glm::normalize(normal);
    return dvec4(unit, -glm::dot(unit, dvec3(*base)));
}

Frustum makeFrustum(const Camera& camera, double aspect) {
    const double halfY = camera.perspective ? std::tan(camera.yfov / 2) : camera.ymag;
    const double halfX = halfY * aspect;
    const bool finite = camera.zfar > 0;
    Frustum f;
    const std::array<std::array<double, 2>, 4> signs{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};  // around the axis
    const auto corner = [&](double sx, double sy, double depth) {
        const double width = camera.perspective ? depth : 1;
        return camera.gridFromCamera * dvec4(sx * halfX * width, sy * halfY * width, -depth, 1);
    };
    for (const auto& s : signs) f.corners.push_back(corner(s[0], s[1], camera.znear));
    for (const auto& s : signs)
        f.corners.push_back(finite ? corner(s[0], s[1], camera.zfar) : camera.gridFromCamera * dvec4(s[0] * halfX, s[1] * halfY, -1, 0));
    dvec3 inside(0);
    for (size_t i = 0; i < 4; ++i) inside += dvec3(f.corners[i]) / 4.0;
    const dvec3 forward = -dvec3(camera.gridFromCamera[2]);
    inside += forward * (finite ? (camera.zfar - camera.znear) / 2 : std::max(camera.znear, 1e-3));
    const auto addFace = [&](size_t a, size_t b, size_t c) {
        const auto plane = planeThrough(f.corners[a], f.corners[b], f.corners[c]);
        dvec4 face = plane.value_or(dvec4(0));
        if (at(face, dvec4(inside, 1)) < 0) face = -face;
        f.faces.push_back(face);
    };
    for (size_t i = 0; i < 4; ++i) addFace(i, (i + 1) % 4, 4 + i);  // side i between rays i and i + 1
    addFace(0, 1, 2);                                               // near: face 4
    if (finite) addFace(4, 5, 6);                                   // far: face 5
    for (size_t i = 0; i < 4; ++i) {
        f.edges.push_back({{i, 4 + i}, {i, (i + 3) % 4}});
        f.edges.push_back({{i, (i + 1) % 4}, {i, 4}});
        if (finite) f.edges.push_back({{4 + i, 4 + (i + 1) % 4}, {i, 5}});
    }
    return f;
}

}  // namespace

std::vector<glm::vec4> cullHull(const Camera& camera, double aspect, glm::vec4 light) {
    const Frustum f = makeFrustum(camera, aspect);
    const dvec4 l(light);
    std::vector<glm::vec4> result;
    const auto add = [&](dvec4 plane) {
        for (const dvec4& corner : f.corners)
            if (at(plane, corner) < -1e-6 * (1 + std::abs(plane.w))) return;  // does not support the hull after all
        if (at(plane, l) < -1e-6 * (1 + std::abs(plane.w)) || result.size() == kMaxCullPlanes) return;
        plane.w += 2e-5 * (1 + std::abs(plane.w));
        result.emplace_back(plane);
    };
    std::vector<bool> holdsLight;
    for (const dvec4& face : f.faces) {
        holdsLight.push_back(at(face, l) >= 0);
        if (holdsLight.back() && face != dvec4(0)) add(face);
    }
    const bool finite = f.faces.size() == 6;
    for (size_t side = 0; side < 4 && !finite && l.w != 0; ++side) {  // through the light and an edge at infinity: parallel to the side
        const dvec3 normal(f.faces[side]);
        if (!holdsLight[side]) add(dvec4(normal, -glm::dot(normal, dvec3(l))));
    }
    for (const Frustum::Edge& edge : f.edges) {
        if (holdsLight[edge.face[0]] == holdsLight[edge.face[1]]) continue;
        auto plane = planeThrough(f.corners[edge.corner[0]], f.corners[edge.corner[1]], l);
        if (!plane) continue;
        double sum = 0;
        for (const dvec4& corner : f.corners) sum += at(*plane, corner);
        add(sum < 0 ? -*plane : *plane);
    }
    return result;
}

}  // namespace gno::host
