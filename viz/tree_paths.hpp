// SPDX-License-Identifier: MIT
// The ways of one sample's queries in the scene, side by side.
#pragma once
#include <span>

#include "viz/options.hpp"
#include "viz/query_path.hpp"

namespace gno::viz {

/// One panel per path: the casters it visits and the way between them, by order; jumps (from the stack, by ancestor links) apart.
void drawPaths(Picture& picture, const Dump& dump, std::span<const QueryPath> paths, std::span<const Corners> corners);

/// Around the sample: what holds nine in ten of the places that the paths visit.
Box boxOf(std::span<const QueryPath> paths, std::span<const Corners> corners);

/// The visits up to a step alone, of one path; returns the actors.
std::vector<vtkSmartPointer<vtkActor>> addPath(vtkRenderer& panel, const Dump& dump, const QueryPath& path, std::span<const Corners> corners,
                                               vtkLookupTable& colours, size_t steps);

}  // namespace gno::viz
