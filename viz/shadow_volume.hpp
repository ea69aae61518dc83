// SPDX-License-Identifier: MIT
// A shadow volume clipped to a box: the part of the box behind the caster's plane and inside the three planes through the light.
#pragma once
#include <array>
#include <vector>

#include <glm/glm.hpp>

#include "viz/scene_mesh.hpp"

namespace gno::viz {

using Polygon = std::vector<glm::dvec3>;

/// Faces of box and planes, on the grid; empty when nothing of the volume is in the box. `planes` as the device made them: in the coordinates of gnoFromLight for this
/// homogeneous light, inside is negative.
std::vector<Polygon> clippedVolume(const Box& box, glm::vec4 light, const std::array<glm::vec4, 4>& planes);

}  // namespace gno::viz
