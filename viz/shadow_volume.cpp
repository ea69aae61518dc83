// SPDX-License-Identifier: MIT
#include "viz/shadow_volume.hpp"

#include <algorithm>
#include <cmath>

namespace gno::viz {
namespace {

struct Plane {
    glm::dvec3 normal;
    double offset;
    [[nodiscard]] double side(const glm::dvec3& p) const { return glm::dot(normal, p) + offset; }
};

std::vector<Polygon> facesOf(const Box& box) {
    std::vector<Polygon> faces;
    for (int axis = 0; axis < 3; ++axis)
        for (const double at : {box.low[axis], box.high[axis]}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            Polygon face;
            for (const auto& [onU, onV] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
                glm::dvec3 p;
                p[axis] = at;
                p[u] = onU ? box.high[u] : box.low[u];
                p[v] = onV ? box.high[v] : box.low[v];
                face.push_back(p);
            }
            faces.push_back(std::move(face));
        }
    return faces;
}

/// The part of a polygon where the plane is not positive; points on the plane go to `seam` too.
Polygon cut(const Polygon& polygon, const Plane& plane, std::vector<glm::dvec3>& seam) {
    Polygon kept;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double sideA = plane.side(a), sideB = plane.side(b);
        if (sideA <= 0) kept.push_back(a);
        if ((sideA < 0 && sideB > 0) || (sideA > 0 && sideB < 0)) {
            const glm::dvec3 p = a + (b - a) * (sideA / (sideA - sideB));
            kept.push_back(p);
            seam.push_back(p);
        } else if (sideA == 0) {
            seam.push_back(a);
        }
    }
    return kept;
}

/// The face that a plane leaves in a convex body: the seam's points around their middle, doubles left out.
Polygon faceOf(const std::vector<glm::dvec3>& seam, const Plane& plane) {
    if (seam.size() < 3) return {};
    glm::dvec3 middle(0);
    for (const glm::dvec3& p : seam) middle += p / double(seam.size());
    const glm::dvec3 any = std::abs(plane.normal.x) < 0.6 * glm::length(plane.normal) ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(plane.normal, any)), v = glm::normalize(glm::cross(plane.normal, u));
    std::vector<std::pair<double, glm::dvec3>> around;
    for (const glm::dvec3& p : seam) around.emplace_back(std::atan2(glm::dot(p - middle, v), glm::dot(p - middle, u)), p);
    std::sort(around.begin(), around.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    Polygon face;
    for (const auto& [angle, p] : around)
        if (face.empty() || glm::length(p - face.back()) > 1e-12) face.push_back(p);
    return face;
}

}  // namespace

std::vector<Polygon> clippedVolume(const Box& box, glm::vec4 light, const std::array<glm::vec4, 4>& planes) {
    std::vector<Polygon> faces = facesOf(box);
    for (const glm::vec4& stored : planes) {
        const glm::dvec3 normal(stored);
        if (normal == glm::dvec3(0)) continue;  // a plane that fp32 cannot tell: everything is in its band
        const Plane plane{normal, double(stored.w) - (light.w != 0 ? glm::dot(normal, glm::dvec3(light)) : 0.0)};
        std::vector<glm::dvec3> seam;
        std::vector<Polygon> left;
        for (const Polygon& face : faces)
            if (Polygon part = cut(face, plane, seam); part.size() >= 3) left.push_back(std::move(part));
        if (Polygon face = faceOf(seam, plane); !left.empty() && face.size() >= 3) left.push_back(std::move(face));
        faces = std::move(left);
    }
    return faces;
}

Polygon clipped(Polygon polygon, std::span<const glm::dvec4> planes) {
    std::vector<glm::dvec3> seam;
    for (const glm::dvec4& plane : planes) polygon = cut(polygon, {glm::dvec3(plane), plane.w}, seam);
    return polygon.size() >= 3 ? polygon : Polygon{};
}

}  // namespace gno::viz
