// SPDX-License-Identifier: MIT
#include <cmath>

#include "host_min/scene/scene.hpp"

namespace gno::host {

glm::dmat4 Camera::clipFromGrid(double aspect) const {
    const glm::dmat3 turn = glm::transpose(glm::dmat3(gridFromCamera));  // the inverse of a rotation
    glm::dmat4 cameraFromGrid(turn);
    cameraFromGrid[3] = glm::dvec4(-(turn * glm::dvec3(gridFromCamera[3])), 1.0);

    // Vulkan's clip space has y down; depth is 1 at znear and 0 at zfar. The camera looks along -z: a point at distance d has z = -d.
    glm::dmat4 clip(0.0);
    if (!perspective) {
        clip[0][0] = 1 / (ymag * aspect);
        clip[1][1] = -1 / ymag;
        clip[2][2] = 1 / (zfar - znear);
        clip[3][2] = zfar / (zfar - znear);
        clip[3][3] = 1;
        return clip * cameraFromGrid;
    }
    const double cotangent = 1 / std::tan(yfov / 2);
    clip[0][0] = cotangent / aspect;
    clip[1][1] = -cotangent;
    clip[2][2] = zfar > 0 ? znear / (zfar - znear) : 0;
    clip[3][2] = zfar > 0 ? znear * zfar / (zfar - znear) : znear;
    clip[2][3] = -1;
    return clip * cameraFromGrid;
}

glm::dvec4 Camera::viewer() const {
    return perspective ? glm::dvec4(glm::dvec3(gridFromCamera[3]), 1.0) : glm::dvec4(glm::dvec3(gridFromCamera[2]), 0.0);
}

}  // namespace gno::host
