// SPDX-License-Identifier: MIT
// Cutting with planes: a shadow volume clipped to a box (the part of the box behind the caster's plane and inside the three planes through the
// light), and a polygon.
#pragma once
#include <array>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "viz/scene_mesh.hpp"

namespace gno::viz {

using Polygon = std::vector<glm::dvec3>;

/// Faces of box and planes, on the grid; empty when nothing of the volume is in the box. `planes` as the device made them: in the coordinates of
/// gnoFromLight for this homogeneous light, inside is negative.
std::vector<Polygon> clippedVolume(const Box& box, glm::vec4 light, const std::array<glm::vec4, 4>& planes);

/// The part of a convex polygon where no plane (xyz normal, w offset) is positive; empty when nothing is left.
Polygon clipped(Polygon polygon, std::span<const glm::dvec4> planes);

}  // namespace gno::viz
