// SPDX-License-Identifier: MIT
#include "host_min/techniques/shadow_views.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gno::host {
namespace {

constexpr float kWidestCone = 1.3089969f;  // 75 degrees: beyond that the pyramid's middle gets few texels
constexpr float kGridRadius = 2;           // over sqrt(3): holds casters and samples, whatever the direction

/// Least and largest position along `axis`.
glm::vec2 extent(std::span<const Triangle> casters, glm::vec3 axis) {
    glm::vec2 result(std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest());
    for (const Triangle& t : casters)
        for (const glm::vec3& p : {t.a, t.b, t.c}) {
            const float at = glm::dot(axis, p);
            result = {std::min(result.x, at), std::max(result.y, at)};
        }
    return casters.empty() ? glm::vec2(0) : result;
}

glm::vec2 widened(glm::vec2 range) {  // by far more than rounding, so that no range is empty
    const float by = (range.y - range.x) / 1024 + 0x1p-20f;
    return {range.x - by, range.y + by};
}

/// right and down across a unit vector.
ShadowFrustum along(glm::dvec3 forward, glm::vec4 rect) {
    const glm::dvec3 off = std::abs(forward.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, off));
    return {right, glm::cross(forward, right), forward, rect};
}

}  // namespace

GnoShadowMapView ShadowFrustum::view() const {
    return perspective ? gnoShadowMapPerspective(right, down, forward, rect) : gnoShadowMapOrthographic(right, down, forward, rect, near, far);
}

std::vector<ShadowFrustum> shadowFrusta(const Frame& frame, glm::vec4 light) {
    if (light.w == 0) {
        ShadowFrustum prism = along(-glm::normalize(glm::dvec3(light)), glm::vec4(-kGridRadius, kGridRadius, -kGridRadius, kGridRadius));
        prism.perspective = false;
        return {prism};
    }
    std::vector<ShadowFrustum> result;
    for (const Light& candidate : frame.lights) {
        if (candidate.kind != Light::Kind::spot || candidate.homogeneous != light || candidate.outerCone > kWidestCone) continue;
        const float slope = std::tan(candidate.outerCone);
        result.push_back(along(glm::normalize(glm::dvec3(candidate.axis)), glm::vec4(-slope, slope, -slope, slope)));
        break;
    }
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.f, -1.f}) {
            ShadowFrustum face{glm::vec3(0), glm::vec3(0), glm::vec3(0), {-1, 1, -1, 1}};
            face.forward[axis] = sign;
            face.right[(axis + 1) % 3] = 1;
            face.down[(axis + 2) % 3] = 1;
            result.push_back(face);
        }
    return result;
}

std::vector<ShadowFrustum> fitShadowFrusta(std::span<const ShadowFrustum> frusta, std::span<const uint32_t> measured,
                                           std::span<const Triangle> casters, bool focused) {
    std::vector<ShadowFrustum> result;
    for (size_t i = 0; i < frusta.size(); ++i) {
        const glm::uvec4 bounds(measured[4 * i], measured[4 * i + 1], measured[4 * i + 2], measured[4 * i + 3]);
        if (bounds.x == 0) continue;
        ShadowFrustum fitted = frusta[i];
        if (!fitted.perspective) {
            const glm::vec2 depths = widened(extent(casters, fitted.forward));
            fitted.near = depths.x;
            fitted.far = depths.y;
        }
        if (focused) {
            fitted.rect = gnoShadowMapFit(bounds, fitted.rect);
        } else if (!fitted.perspective) {
            const glm::vec2 across = widened(extent(casters, fitted.right)), downwards = widened(extent(casters, fitted.down));
            fitted.rect = {across.x, across.y, downwards.x, downwards.y};
        }
        result.push_back(fitted);
    }
    return result;
}

}  // namespace gno::host
