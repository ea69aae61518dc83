// SPDX-License-Identifier: MIT
#include "host_min/frame/cull_front.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gno::host {
namespace {

using glm::dvec3;

/// The rectangle in the near plane where the rays of view begin.
class NearRectangle {
public:
    NearRectangle(const Camera& camera, double aspect)
        : turn_(glm::transpose(glm::dmat3(camera.gridFromCamera))), place_(camera.gridFromCamera[3]), depth_(camera.znear) {
        half_.y = camera.perspective ? camera.znear * std::tan(camera.yfov / 2) : camera.ymag;
        half_.x = half_.y * aspect;
        middle_ = dvec3(camera.gridFromCamera * glm::dvec4(0, 0, -camera.znear, 1));
        margin_ = 1e-6 * std::max({half_.x, half_.y, depth_, 1e-12});  // far above the rounding of the numbers here
    }

    [[nodiscard]] const dvec3& middle() const { return middle_; }

    /// Never false for a triangle that touches it.
    [[nodiscard]] bool mayTouch(const Triangle& t) const {
        const std::array<dvec3, 3> p{seen(t.a), seen(t.b), seen(t.c)};
        const auto [nearest, farthest] = std::minmax({-p[0].z, -p[1].z, -p[2].z});
        if (nearest > depth_ + margin_ || farthest < depth_ - margin_) return false;
        // The part of the triangle between depth - margin and depth + margin against the rectangle: apart along an axis, or along the line in which
        // the two planes cross?
        std::vector<glm::dvec2> part;
        for (size_t i = 0; i < 3; ++i) {
            const dvec3 &a = p[i], &b = p[(i + 1) % 3];
            if (std::abs(-a.z - depth_) <= margin_) part.emplace_back(a);
            for (const double depth : {depth_ - margin_, depth_ + margin_}) {
                const double da = -a.z - depth, db = -b.z - depth;
                if ((da < 0 && db > 0) || (da > 0 && db < 0)) part.emplace_back(a + (b - a) * (da / (da - db)));
            }
        }
        const auto apart = [&](glm::dvec2 axis) {
            const double reach = std::abs(axis.x) * (half_.x + margin_) + std::abs(axis.y) * (half_.y + margin_);
            double low = INFINITY, high = -INFINITY;
            for (const glm::dvec2& at : part) {
                low = std::min(low, glm::dot(axis, at));
                high = std::max(high, glm::dot(axis, at));
            }
            return low > reach || high < -reach;
        };
        const dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
        return !(apart({1, 0}) || apart({0, 1}) || apart({normal.x, normal.y}));
    }

private:
    [[nodiscard]] dvec3 seen(dvec3 p) const { return turn_ * (p - place_); }

    glm::dmat3 turn_;
    dvec3 place_, middle_{};
    glm::dvec2 half_{};
    double depth_, margin_ = 0;
};

/// A triangle's solid angle over 4 pi, its sign that of its orientation: a closed mesh's sum is its winding number. Van Oosterom and Strackee, "The
/// solid angle of a plane triangle", IEEE Trans. Biomed. Eng. 30 (1983), eq. 8.
double windingShare(const Triangle& t, dvec3 from) {
    const dvec3 a = dvec3(t.a) - from, b = dvec3(t.b) - from, c = dvec3(t.c) - from;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double over = glm::dot(a, glm::cross(b, c));
    const double under = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    return std::atan2(over, under) / (2 * std::numbers::pi);
}

struct Mesh {
    bool hasClosed = false, opaque = true, touchesNear = false;
    double winding = 0;
    [[nodiscard]] bool cameraOutside() const { return !touchesNear && std::abs(winding) < 0.1; }
};

}  // namespace

FrontCull legalFrontCull(const Frame& frame, double aspect) {
    const NearRectangle rectangle(frame.camera, aspect);
    std::vector<Mesh> meshes;
    for (size_t i = 0; i < frame.closed.size(); ++i) {
        if (!frame.closed[i]) continue;
        const uint32_t number = frame.object[i];
        if (number >= meshes.size()) meshes.resize(number + 1);
        Mesh& mesh = meshes[number];
        mesh.hasClosed = true;
        mesh.opaque = mesh.opaque && (frame.surfaceOf.empty() || frame.surfaceOf[i] == kOpaque);
        mesh.touchesNear = mesh.touchesNear || rectangle.mayTouch(frame.triangles[i]);
        mesh.winding += windingShare(frame.triangles[i], rectangle.middle());
    }
    FrontCull result{std::vector<uint8_t>(frame.triangles.size(), 0), {}};
    for (size_t i = 0; i < frame.closed.size(); ++i)
        result.mayLose[i] = frame.closed[i] && meshes[frame.object[i]].opaque && meshes[frame.object[i]].cameraOutside();
    const auto count = [&](auto&& use) { return std::count_if(meshes.begin(), meshes.end(), use); };
    const auto closed = count([](const Mesh& m) { return m.hasClosed; });
    const auto holes = count([](const Mesh& m) { return m.hasClosed && !m.opaque; });
    const auto entered = count([](const Mesh& m) { return m.hasClosed && m.opaque && !m.cameraOutside(); });
    if (holes + entered > 0)
        result.leftWhole = fmt::format(
            "cull=front: of {} meshes with closed parts, {} not wholly opaque and {} that the camera or its near plane "
            "enters keep all of their triangles",
            closed, holes, entered);
    return result;
}

}  // namespace gno::host
