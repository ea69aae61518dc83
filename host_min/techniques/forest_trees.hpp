// SPDX-License-Identifier: MIT
// A forest of TOP trees on the device, one per cell of the light's grid, built with glsl/forest and glsl/top as any engine would.
#pragma once
#include <vector>

#include "glsl/top/node.h"
#include "host_min/output/record.hpp"
#include "host_min/techniques/cell_assignment.hpp"
#include "host_min/techniques/technique.hpp"
#include "host_min/techniques/top_tree.hpp"

namespace gno::host {

struct ForestOptions {
    Precision precision = Precision::certified;
    uint32_t resolution = 0;  ///< cells along an edge of a face; 0: chosen by counting pairs at several
    bool viewCull = true, cover = true;
    bool slab = false;        ///< bounds of a node's children, kept in the node
    bool storePlanes = true;  ///< false: the build and the queries compute a node's plane from its caster
    uint32_t pool = 0;        ///< pairs; 0: as many as the frame needs, which one read-back tells
    uint32_t seed = 1;        ///< of the insertion order
    uint32_t repeat = 1;
    bool warmUp = true;
    bool counters = true;
};

class ForestTrees {
public:
    /// Throws InputError when an array would pass the device's limits, or the given pool is too small.
    ForestTrees(const FrameInputs& inputs, const ForestOptions& options);

    [[nodiscard]] std::vector<Binding> resources() const;  ///< what a query binds, its own images left out
    [[nodiscard]] const std::vector<RecordPass>& passes() const { return passes_; }
    [[nodiscard]] const TopBuildCounters& counters() const { return counters_; }
    [[nodiscard]] uint32_t resolution() const { return assignment_.resolution(); }
    [[nodiscard]] const GnoForestHeader& found() const { return found_; }  ///< pairs, used cells, casters with some and with many cells
    [[nodiscard]] NamedNumbers bytes() const;
    [[nodiscard]] std::vector<DumpedBuffer> dump() const;

private:
    void count(uint32_t resolution);
    void chooseResolution();
    void recordAssignment(Recording& recording) const;
    void recordTrees(Recording& recording, const Buffer* totals) const;

    const FrameInputs& inputs_;
    ForestOptions options_;
    CellAssignment assignment_;
    GnoForestHeader found_{};  ///< what the assignment counted
    Buffer planes_, links_, slabs_;
    std::vector<RecordPass> passes_;
    TopBuildCounters counters_;
};

}  // namespace gno::host
