// SPDX-License-Identifier: MIT
// Random cameras and lights in and around [-1, 1], and which points lie in the convex hull of frustum and light: by clipping a ray to the frustum in
// camera space, without a plane of the hull.
#pragma once
#include <algorithm>
#include <cmath>
#include <random>

#include "host_min/scene/grid.hpp"
#include "host_min/scene/scene.hpp"

namespace gno::test {

class Random {
public:
    explicit Random(uint32_t seed) : engine_(seed) {}
    double unit() { return double(engine_()) / 4294967296.0; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    glm::dvec3 inBox(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
    glm::dvec3 direction() {
        for (;;) {
            const glm::dvec3 d = inBox(1);
            const double length = glm::length(d);
            if (length > 0.1 && length < 1) return d / length;
        }
    }
    uint32_t below(uint32_t count) { return uint32_t(unit() * count); }

private:
    std::mt19937 engine_;
};

inline host::Camera randomCamera(Random& random) {
    host::Camera camera;
    const glm::dvec3 z = random.direction();
    const glm::dvec3 x = glm::normalize(glm::cross(random.direction(), z) + 1e-9);
    const glm::dvec3 right = glm::normalize(x - z * glm::dot(x, z));
    const glm::dvec3 position = random.unit() < 0.5 ? random.inBox(0.9) : z * random.between(1, 4) + random.inBox(0.3);
    camera.gridFromCamera = glm::dmat4(glm::dvec4(right, 0), glm::dvec4(glm::cross(z, right), 0), glm::dvec4(z, 0), glm::dvec4(position, 1));
    camera.perspective = random.unit() < 0.7;
    camera.yfov = random.between(0.05, 2.5);
    camera.ymag = random.between(0.05, 1.2);
    camera.znear = random.unit() < 0.2 ? random.between(0.5, 1.5) : random.between(0.001, 0.05);
    camera.zfar = camera.perspective && random.unit() < 0.4 ? 0 : camera.znear + random.between(0.2, 6);
    return camera;
}

enum class LightPlace { inside, behind, anywhere, far, directional, alongTheView, alongAnAxis };

inline glm::vec4 randomLight(Random& random, const host::Camera& camera, double aspect, LightPlace place) {
    const glm::dmat4& m = camera.gridFromCamera;
    const auto point = [](glm::dvec3 p) { return glm::vec4(host::snapCoordinate(p.x), host::snapCoordinate(p.y), host::snapCoordinate(p.z), 1); };
    const auto fromCamera = [&](glm::dvec3 p) { return glm::clamp(glm::dvec3(m * glm::dvec4(p, 1)), glm::dvec3(-1.9), glm::dvec3(1.9)); };
    switch (place) {
        case LightPlace::inside: {
            const double depth = camera.znear + random.between(0.05, 0.9) * ((camera.zfar > 0 ? camera.zfar : camera.znear + 2) - camera.znear);
            const double half = camera.perspective ? depth * std::tan(camera.yfov / 2) : camera.ymag;
            return point(fromCamera({random.between(-1, 1) * half * aspect, random.between(-1, 1) * half, -depth}));
        }
        case LightPlace::behind:
            return point(fromCamera({random.between(-0.2, 0.2), random.between(-0.2, 0.2), random.between(0.01, 1)}));
        case LightPlace::far:
            return glm::vec4(random.direction() * random.between(10, 1000), 1);
        case LightPlace::directional:
            return glm::vec4(host::snapDirection(random.direction()), 0);
        case LightPlace::alongTheView:
            return glm::vec4(host::snapDirection(glm::dvec3(m[2]) * (random.unit() < 0.5 ? 1.0 : -1.0)), 0);
        case LightPlace::alongAnAxis: {
            glm::dvec3 axis(0);
            axis[int(random.below(3))] = random.unit() < 0.5 ? 1 : -1;
            return glm::vec4(axis, 0);
        }
        case LightPlace::anywhere:
            break;
    }
    return point(random.inBox(1.5));
}

/// Is `q` between the light and a point of the frustum? `slack` widens the frustum on all sides.
inline bool inHull(const host::Camera& camera, double aspect, glm::vec4 light, glm::dvec3 q, double slack) {
    const glm::dmat3 turn = glm::transpose(glm::dmat3(camera.gridFromCamera));
    const glm::dvec3 origin(camera.gridFromCamera[3]), l(light);
    const glm::dvec3 start = turn * (q - origin);                                  // camera space
    const glm::dvec3 away = turn * (light.w != 0 ? q - l / double(light.w) : -l);  // from the light, through q and on
    double low = 0, high = 1e30;
    const auto clip = [&](double at, double slope) {  // keep at + s * slope >= -slack
        at += slack;
        if (slope == 0 && at < 0) high = -1;
        if (slope > 0) low = std::max(low, -at / slope);
        if (slope < 0) high = std::min(high, -at / slope);
    };
    const double halfY = camera.perspective ? std::tan(camera.yfov / 2) : camera.ymag, halfX = halfY * aspect;
    for (const double side : {-1.0, 1.0}) {
        const double perDepth = camera.perspective ? 1 : 0, constant = camera.perspective ? 0 : 1;
        const double lengthX = std::hypot(1.0, halfX * perDepth), lengthY = std::hypot(1.0, halfY * perDepth);
        clip((halfX * (constant - perDepth * start.z) - side * start.x) / lengthX, (-halfX * perDepth * away.z - side * away.x) / lengthX);
        clip((halfY * (constant - perDepth * start.z) - side * start.y) / lengthY, (-halfY * perDepth * away.z - side * away.y) / lengthY);
    }
    clip(-start.z - camera.znear, -away.z);
    if (camera.zfar > 0) clip(camera.zfar + start.z, away.z);
    return low <= high;
}

}  // namespace gno::test
