// SPDX-License-Identifier: MIT
// One cell of a forest in the scene: its pyramid from the light, and the casters of its tree.
#pragma once
#include <span>
#include <string>

#include "viz/forest.hpp"
#include "viz/scene_mesh.hpp"
#include "viz/shadow_volume.hpp"
#include "viz/volume_look.hpp"

namespace gno::viz {

struct CellTree {
    uint32_t cell = 0;
    std::vector<Volume> volumes;  ///< by depth; `caster` and `parent` of the scene
    std::vector<Polygon> parts;   ///< by volume: its caster inside the pyramid as it is drawn, on the grid; may be empty
    size_t byMargins = 0;         ///< casters that lie outside the cell, and are kept by the margins of its test
    double nearest = 0,
           farthest = 0;  ///< depths (Forest::depthOf) between which the pyramid is drawn: to its farthest view sample, or out of the scene
    Box box{};            ///< of the parts and the pyramid's end

    /// Throws InputError: there is no such cell, or it keeps no casters.
    static CellTree read(const Dump& dump, const Forest& forest, std::span<const Corners> corners, uint32_t cell);
    [[nodiscard]] std::string numbers(const Forest& forest) const;  ///< one line
};

/// Triangles of the first `count` casters. Cell arrays: caster, parent (GNO_TOP_NONE: the root), depth, nodes_above, link, least_distance.
vtkSmartPointer<vtkPolyData> casterMesh(const Dump& dump, const CellTree& tree, std::span<const Corners> corners, size_t count);
/// The parts of them in the pyramid, with the same arrays.
vtkSmartPointer<vtkPolyData> partMesh(const Dump& dump, const CellTree& tree, size_t count);
/// Four edges and both ends.
vtkSmartPointer<vtkPolyData> pyramidMesh(const Dump& dump, const Forest& forest, const CellTree& tree);

}  // namespace gno::viz
