// SPDX-License-Identifier: MIT
// What colours tell of a tree's volumes, and what VTK files say of them.
#pragma once
#include <span>
#include <string>
#include <vector>

#include <vtkDataSetAttributes.h>

#include "viz/picture.hpp"
#include "viz/top_tree.hpp"

namespace gno::viz {

struct Coloring {
    std::string array, title;
    vtkSmartPointer<vtkLookupTable> table;
};

/// `color`: depth, kind, distance or visits; its scale holds all of `drawn`.
Coloring coloringOf(const std::string& color, std::span<const Volume> drawn);
void addLegend(Picture& picture, int panel, const std::string& color, const Coloring& coloring);

/// One value per entry of `ids`, each a volume: caster, depth, nodes_above, link, least_distance; with `visits`: visits.
void addVolumeArrays(vtkDataSetAttributes& target, std::span<const Volume> volumes, std::span<const uint32_t> ids, bool visits);
/// Adds cell array "drawn": red, green, blue, opacity. Large casters (cell array "caster") are more transparent, so that they do not hide the small
/// ones.
void fade(vtkPolyData& mesh, const Dump& dump, std::span<const Corners> corners, const Coloring& coloring);
inline constexpr const char* kLinksFact = "0 root, 1 positive child, 2 positive child of a cap, 3 intersection child";

}  // namespace gno::viz
