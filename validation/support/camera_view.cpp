// SPDX-License-Identifier: MIT
#include "validation/support/camera_view.hpp"

#include <algorithm>
#include <cmath>

#include "host_min/scene/grid.hpp"
#include "validation/support/glsl_as_cpp.hpp"

namespace gno {  // core/orient3d.glsl opens no namespace, what includes it opens its own: gno::gno
#include "glsl/core/sample.glsl"
using namespace gno;
}  // namespace gno

namespace gno::test {
namespace {

using glm::dvec3;

dvec3 axis(const host::Camera& camera, int column) { return dvec3(camera.gridFromCamera[column]); }

struct Ray {
    dvec3 from, along;  ///< along: one unit of depth
};

Ray rayOf(const CameraView& view, double x, double y) {
    const host::Camera& camera = view.frame.camera;
    const double half = camera.perspective ? std::tan(camera.yfov / 2) : camera.ymag;
    const double right = (2 * x / view.width - 1) * half * view.width / view.height, up = (1 - 2 * y / view.height) * half;
    const dvec3 aside = axis(camera, 0) * right + axis(camera, 1) * up, eye = axis(camera, 3);
    return camera.perspective ? Ray{eye, -axis(camera, 2) + aside} : Ray{eye + aside, -axis(camera, 2)};
}

/// Depth at which the ray meets the triangle; infinity where it does not, or nearer than `least`.
double hit(const Ray& ray, const host::Triangle& t, double least) {
    const dvec3 a(t.a), e = dvec3(t.b) - a, f = dvec3(t.c) - a, h = glm::cross(ray.along, f);
    const double det = glm::dot(e, h);
    if (det == 0) return INFINITY;
    const dvec3 s = ray.from - a, q = glm::cross(s, e);
    const double u = glm::dot(s, h) / det, v = glm::dot(ray.along, q) / det, depth = glm::dot(f, q) / det;
    return u >= 0 && v >= 0 && u + v <= 1 && depth > least ? depth : INFINITY;
}

glm::vec3 snapped(dvec3 v) { return {host::snapCoordinate(v.x), host::snapCoordinate(v.y), host::snapCoordinate(v.z)}; }

struct Window {
    uint32_t left, top, right, bottom;
};

/// Pixels that may see the triangle; all of them when it comes nearer than the near plane.
Window windowOf(const CameraView& view, const host::Triangle& t) {
    const host::Camera& camera = view.frame.camera;
    const double half = camera.perspective ? std::tan(camera.yfov / 2) : camera.ymag;
    double left = view.width, right = 0, top = view.height, bottom = 0;
    for (const glm::vec3 v : {t.a, t.b, t.c}) {
        const dvec3 d = dvec3(v) - axis(camera, 3);
        const double depth = glm::dot(d, -axis(camera, 2)), k = camera.perspective ? half * depth : half;
        if (depth < camera.znear) return {0, 0, view.width, view.height};
        const double x = (glm::dot(d, axis(camera, 0)) / k * view.height / view.width + 1) / 2 * view.width;
        const double y = (1 - glm::dot(d, axis(camera, 1)) / k) / 2 * view.height;
        left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
    }
    const auto pixel = [](double at, uint32_t most) { return uint32_t(std::clamp(at, 0.0, double(most))); };
    return {pixel(left - 1, view.width), pixel(top - 1, view.height), pixel(right + 2, view.width), pixel(bottom + 2, view.height)};
}

}  // namespace

host::Camera lookAt(glm::dvec3 eye, glm::dvec3 at, double extent, bool perspective) {
    const dvec3 back = glm::normalize(eye - at), right = glm::normalize(glm::cross(std::abs(back.y) > 0.9 ? dvec3(0, 0, 1) : dvec3(0, 1, 0), back));
    host::Camera camera;
    camera.perspective = perspective;
    camera.gridFromCamera =
        glm::dmat4(glm::dvec4(right, 0), glm::dvec4(glm::cross(back, right), 0), glm::dvec4(back, 0), glm::dvec4(dvec3(snapped(eye)), 1));
    camera.yfov = 2 * std::atan(extent);
    camera.ymag = extent;
    return camera;
}

glm::dvec3 pointAt(const CameraView& view, double x, double y, double depth) {
    const Ray ray = rayOf(view, x, y);
    return ray.from + ray.along * depth;
}

void fillPixels(CameraView& view) {
    const auto& triangles = view.frame.triangles;
    for (auto* list : {&view.frame.material, &view.frame.object}) list->assign(triangles.size(), 0);
    view.frame.closed.assign(triangles.size(), 0);
    std::vector<double> nearest(size_t(view.width) * view.height, INFINITY);
    std::vector<uint32_t> own(nearest.size(), GNO_BACKGROUND);
    for (uint32_t k = 0; k < triangles.size(); ++k) {
        const Window window = windowOf(view, triangles[k]);
        for (uint32_t y = window.top; y < window.bottom; ++y)
            for (uint32_t x = window.left; x < window.right; ++x) {
                const size_t i = size_t(y) * view.width + x;
                const double depth = hit(rayOf(view, x + 0.5, y + 0.5), triangles[k], view.frame.camera.znear);
                if (depth < nearest[i]) nearest[i] = depth, own[i] = k;
            }
    }
    const glm::vec4 viewer(view.frame.camera.viewer());
    view.pixels.assign(nearest.size(), {glm::vec3(0), GNO_BACKGROUND});
    for (uint32_t i = 0; i < nearest.size(); ++i) {
        if (own[i] == GNO_BACKGROUND) continue;
        const host::Triangle& t = triangles[own[i]];
        const glm::vec3 p = snapped(pointAt(view, i % view.width + 0.5, i / view.width + 0.5, nearest[i]));
        const GnoViewSample s = gnoMakeViewSample(p, own[i], {t.a, t.b, t.c}, viewer, view.light);
        view.pixels[i] = {s.position, s.own};
    }
}

void fillPixels(CameraView& view, const std::vector<double>& depths) {
    view.pixels.assign(size_t(view.width) * view.height, {glm::vec3(0), GNO_BACKGROUND});
    for (uint32_t i = 0; i < view.pixels.size(); ++i)
        if (depths.at(i) != 0) view.pixels[i] = {snapped(pointAt(view, i % view.width + 0.5, i / view.width + 0.5, depths[i])), GNO_NO_CASTER};
}

std::vector<uint32_t> oracleMask(const CameraView& view) {
    std::vector<host::OracleSample> samples;
    for (const host::OracleSample& pixel : view.pixels)
        if (pixel.own <= GNO_NO_CASTER) samples.push_back(pixel);
    const host::OracleAnswer answer = host::makeOracle()->ask({view.frame.triangles, {}, view.light, samples}, [](double) {});
    std::vector<uint32_t> mask;
    size_t next = 0;
    for (const host::OracleSample& pixel : view.pixels) {
        if (pixel.own == GNO_BACKGROUND)
            mask.push_back(GNO_VISIBILITY_BACKGROUND);
        else if (pixel.own == GNO_FACING_AWAY)
            mask.push_back(GNO_VISIBILITY_FACING_AWAY);
        else
            mask.push_back(answer.inShadow[next++] != 0 ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT);
    }
    return mask;
}

}  // namespace gno::test
