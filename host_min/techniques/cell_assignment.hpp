// SPDX-License-Identifier: MIT
// Casters in the cells of the light's grid, by glsl/forest/assign.glsl: what a forest of trees and a grid of lists begin with.
#pragma once
#include <string>
#include <vector>

#include "glsl/forest/cells.h"
#include "host_min/techniques/technique.hpp"

namespace gno::host {

/// The contract's grid for a light: six faces around a point, or one face that holds the box from `low` to `high` (casters) and all samples.
GnoForestGrid forestGrid(glm::vec4 light, glm::vec3 low, glm::vec3 high, uint32_t resolution);

class CellAssignment {
public:
    /// `owner`: of the words "the OWNER's limit". Throws InputError when there are too many triangles for one row of work groups.
    CellAssignment(const FrameInputs& inputs, const char* owner, bool viewCull, bool cover, uint32_t seed);

    void setResolution(uint32_t resolution);  ///< grid, and empty cells
    void setPool(uint64_t pairs);             ///< how many it holds; at first one
    [[nodiscard]] uint32_t resolution() const { return resolution_; }
    [[nodiscard]] uint32_t cellCount() const { return cellCount_; }

    // Each begins and ends without a barrier of its own.
    void recordDepth(Recording& recording) const;  ///< empty cells, and how far their samples lie
    void recordSort(Recording& recording) const;   ///< casters by the number of their cells
    void recordCount(Recording& recording) const;  ///< what hides cells, and how many casters each keeps
    void recordEmit(Recording& recording) const;

    [[nodiscard]] const Buffer& header() const { return header_; }
    [[nodiscard]] const Buffer& cells() const { return cells_; }
    [[nodiscard]] const Buffer& pool() const { return pool_; }
    [[nodiscard]] const Buffer& grid() const { return grid_; }
    [[nodiscard]] std::vector<Binding> resources() const;  ///< casters, states, samples, and all of this
    [[nodiscard]] uint64_t cellBytes() const { return cells_.bytes() + grid_.bytes() + header_.bytes(); }
    [[nodiscard]] uint64_t casterBytes() const { return list_.bytes() + few_.bytes(); }

private:
    void step(Recording& recording, uint32_t which, const std::vector<Binding>& resources) const;
    [[nodiscard]] const ComputePass& pass(const std::string& name, Specialization constants = {}) const;

    const FrameInputs& inputs_;
    bool viewCull_, cover_;
    uint32_t seed_, resolution_ = 0, cellCount_ = 0;
    Buffer grid_, cells_, header_, list_, few_, pool_;
};

}  // namespace gno::host
