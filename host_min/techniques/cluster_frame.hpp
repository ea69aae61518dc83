// SPDX-License-Identifier: MIT
// A scene's camera as glsl/core/grid.hpp wants it.
#pragma once
#include <cmath>

#include "glsl/core/grid.hpp"
#include "host_min/scene/scene.hpp"

namespace gno::host {

inline ClusterFrame clusterFrame(const Camera& camera, uint32_t width, uint32_t height) {
    const auto column = [&](int i, double sign) {
        const glm::dvec3 v = sign * glm::dvec3(camera.gridFromCamera[i]);
        return Double3{v.x, v.y, v.z};
    };
    return gno::clusterFrame(column(3, 1), column(0, 1), column(1, 1), column(2, -1), camera.perspective,
                             camera.perspective ? std::tan(camera.yfov / 2) : camera.ymag, width, height);
}

}  // namespace gno::host
