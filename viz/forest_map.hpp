// SPDX-License-Identifier: MIT
// All cells of a forest on the unfolded cube around the light; a light at infinity: on one rectangle.
#pragma once
#include <string>

#include "viz/forest.hpp"
#include "viz/options.hpp"

namespace gno::viz {

/// One quadrangle a cell, in its order. Lengths: a face is 2 wide (a light at infinity: metres). Cell arrays: casters, volumes, deepest, samples,
/// visits_per_sample, most_visits.
vtkSmartPointer<vtkPolyData> cellMesh(const Dump& dump, const Forest& forest);

/// `color`: casters, or visits (the mean over the view samples in a cell).
void drawCells(Picture& picture, const Dump& dump, const Forest& forest, const std::string& color);

}  // namespace gno::viz
