// SPDX-License-Identifier: MIT
// The way of one sample's query through a TOP tree, as the device logged it (glsl/top/examples/trace.glsl).
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "viz/colours.hpp"
#include "viz/scene_mesh.hpp"
#include "viz/top_tree.hpp"

namespace gno::viz {

enum class Step : uint32_t { root, negative, positive, intersection, pop, ancestor, restart };  ///< GNO_TOP_TRACE_*
const std::vector<Kind>& stepKinds();                                                           ///< by Step

struct Visit {
    uint32_t node = 0;
    Step step = Step::root;
    uint32_t depth = 0;  ///< nodes above this one in the tree
};

struct QueryPath {
    std::string technique, precision;
    glm::uvec2 pixel{0};
    glm::vec3 sample{0};  ///< on the grid
    bool inShadow = false;
    std::vector<Visit> visits{};

    /// Throws InputError: the dump has no trace, or one that does not fit its tree.
    static QueryPath read(const Dump& dump, const TopTree& tree);
    [[nodiscard]] size_t count(Step step) const;
};

/// Where a node is drawn, on the grid: a lateral plane at the middle of its edge, a cap at the caster's middle.
glm::dvec3 placeOf(uint32_t node, std::span<const Corners> corners);

/// The visited nodes in order as points joined by lines. Point arrays: order, node, caster, plane (0..2 lateral, 3 cap), step, depth. Line array:
/// step.
vtkSmartPointer<vtkPolyData> pathMesh(const Dump& dump, const QueryPath& path, std::span<const Corners> corners);

}  // namespace gno::viz
