// SPDX-License-Identifier: MIT
// What all views share of a dump's scene: its casters as a mesh, its box and its light. Positions in world units (glTF: metres).
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <glm/glm.hpp>

#include "viz/dump.hpp"

namespace gno::viz {

using Corners = std::array<glm::vec3, 3>;  ///< of a caster, on the grid

std::vector<Corners> cornersOf(const Dump& dump);

/// Triangles of these casters, in this order, with cell array "caster" (its index). `which` empty: all.
vtkSmartPointer<vtkPolyData> meshOf(const Dump& dump, std::span<const Corners> corners, std::span<const uint32_t> which = {});

/// At most `count` casters, the largest ones, for a background that shows the scene's shape.
std::vector<uint32_t> largestCasters(std::span<const Corners> corners, size_t count);

struct Box {
    glm::dvec3 low, high;
};
/// Of the casters, a little larger, on the grid.
Box boxOf(const Dump& dump);

/// The light for a picture: a point light's position, or a point beyond the box towards a light at infinity; world units.
glm::dvec3 lightMarkOf(const Dump& dump);

}  // namespace gno::viz
