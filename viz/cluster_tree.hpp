// SPDX-License-Identifier: MIT
// A dumped hierarchy of view-sample clusters (glsl/clusters/cluster.h) as a list of its occupied nodes.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "glsl/clusters/cluster.h"
#include "viz/dump.hpp"

namespace gno::viz {

struct ClusterNode {
    uint32_t level = 0;  ///< 1 .. levels; at `levels` it is a cluster
    uint32_t key = 0;
    bool accepted = false;  ///< some caster's volume holds all of it
    bool boxed = false;     ///< low and high are the device's bounds
    glm::vec3 low{0}, high{0};
};

struct ClusterTree {
    GnoClusterFrame frame{};
    GnoClusterLayout layout{};
    std::vector<ClusterNode> nodes;  ///< occupied ones, by level
    std::vector<float> slices;       ///< where each depth slice begins, and the end; grid units
    std::vector<size_t> occupied;    ///< nodes by level, [0] is 0
    std::vector<size_t> accepted;

    /// Throws InputError: the dump is no cluster hierarchy's, or a child has no parent.
    static ClusterTree read(const Dump& dump);
    /// The eight corners of the piece of the view that a key stands for, on the grid: x fastest, then y, then depth.
    [[nodiscard]] std::array<glm::dvec3, 8> cellOf(const ClusterNode& node) const;
};

}  // namespace gno::viz
