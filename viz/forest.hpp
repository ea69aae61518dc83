// SPDX-License-Identifier: MIT
// A dumped forest (glsl/forest/cells.h): the cells of the light's grid, what each of them keeps, and what the frame's queries visited in it.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "glsl/forest/cells.h"
#include "viz/dump.hpp"
#include "viz/top_tree.hpp"

namespace gno::viz {

struct ForestCell {
    uint32_t first = 0, casters = 0;    ///< the blocks of the pool that are this cell's: first .. first + casters - 1
    uint32_t root = GNO_FOREST_NONE;    ///< of its tree
    uint32_t volumes = 0, deepest = 0;  ///< in its tree; casters that another one made needless are not
    uint32_t samples = 0;               ///< view samples in it
    uint32_t mostVisits = 0;            ///< visited nodes of one of them
    uint64_t visits = 0;                ///< of all
    [[nodiscard]] double visitsPerSample() const { return samples > 0 ? double(visits) / samples : 0; }
};

/// The four edges of a cell's pyramid round it (a light at infinity: of its prism): points at + depth * along, depths in grid units along the face's
/// axis (the light's direction), on the grid.
struct CellEdge {
    glm::dvec3 at, along;
};

struct Forest {
    GnoForestGrid grid{};
    glm::vec4 light{0};
    std::vector<ForestCell> cells;
    std::vector<uint32_t> casterOfBlock;
    std::vector<GnoTopLink> links;
    uint64_t used = 0;     ///< cells that keep casters
    uint64_t volumes = 0;  ///< in all trees
    uint64_t samples = 0, visits = 0;

    /// Throws InputError: the dump is no forest's, its buffers contradict each other, or their sums its record.
    static Forest read(const Dump& dump);

    /// By depth, the root first; empty where the cell keeps no casters.
    [[nodiscard]] std::vector<Volume> treeOf(const Dump& dump, uint32_t cell) const;
    [[nodiscard]] uint32_t fullestCell() const;  ///< with most casters, the first of them
    [[nodiscard]] uint32_t dearestCell() const;  ///< with most visited nodes a sample
    [[nodiscard]] uint32_t faceOf(uint32_t cell) const { return cell / (grid.resolution * grid.resolution); }
    [[nodiscard]] uint32_t columnOf(uint32_t cell) const { return cell % grid.resolution; }
    [[nodiscard]] uint32_t rowOf(uint32_t cell) const { return cell / grid.resolution % grid.resolution; }

    [[nodiscard]] uint32_t cellAt(glm::vec3 p) const;                           ///< of a point on the grid, as the device finds it (gnoCellOf)
    [[nodiscard]] glm::dvec3 axisOf(uint32_t face) const;                       ///< away from the light, through the face's middle
    [[nodiscard]] double depthOf(uint32_t face, glm::dvec3 p) const;            ///< of a point on the grid, along that axis
    [[nodiscard]] glm::dvec2 cornerOf(uint32_t cell, uint32_t corner) const;    ///< 0..3 round the cell, in the face's coordinates (gnoCellPlace)
    [[nodiscard]] glm::dvec3 direction(uint32_t face, glm::dvec2 place) const;  ///< a light at a point: from it, 1 long along the face's axis
    [[nodiscard]] std::array<CellEdge, 4> edgesOf(uint32_t cell) const;
    [[nodiscard]] std::array<glm::dvec4, 4> sidesOf(uint32_t cell) const;  ///< planes of the pyramid (prism), inside negative
};

/// "+x", "-x", ...; a light at infinity has one face, "seen from the light".
std::string faceName(const Forest& forest, uint32_t face);
/// "cell 68 (face +x, column 4, row 4)"
std::string cellName(const Forest& forest, uint32_t cell);

}  // namespace gno::viz
