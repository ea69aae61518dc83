// SPDX-License-Identifier: MIT
// View samples as a camera sees them, without a rasteriser: a ray through the middle of every pixel, nearest triangle, core/sample.glsl compiled as
// C++. For device tests that need samples where their pixels are, at every subgroup width.
#pragma once
#include <vector>

#include "host_min/oracle.hpp"
#include "host_min/scene/scene.hpp"

namespace gno::test {

struct CameraView {
    host::Frame frame;  ///< triangles, camera; nothing is closed
    uint32_t width = 64, height = 48;
    glm::vec4 light{0, 0, 0, 1};
    std::vector<host::OracleSample> pixels;  ///< in rows of `width`; own may be GNO_FACING_AWAY or GNO_BACKGROUND
};

/// A camera at `eye` that looks at `at`; `extent`: tangent of half the vertical field of view, orthographic: half the height in grid units.
host::Camera lookAt(glm::dvec3 eye, glm::dvec3 at, double extent, bool perspective = true);

/// Where the ray through pixel (x, y) is at `depth` along the viewing direction; (0.5, 0.5) is the middle of the first pixel.
glm::dvec3 pointAt(const CameraView& view, double x, double y, double depth);

/// Casts the rays.
void fillPixels(CameraView& view);

/// Samples on no caster at given depths, one per pixel; depth 0: background.
void fillPixels(CameraView& view, const std::vector<double>& depths);

/// GNO_VISIBILITY_* of every pixel by the oracle.
std::vector<uint32_t> oracleMask(const CameraView& view);

}  // namespace gno::test
