// SPDX-License-Identifier: MIT
// Lists of casters per cell of the light's grid on the device, built with glsl/forest and glsl/rivals/light_grid* as any engine would.
#pragma once
#include <vector>

#include "glsl/rivals/light_grid.h"
#include "host_min/output/record.hpp"
#include "host_min/techniques/cell_assignment.hpp"
#include "host_min/techniques/technique.hpp"

namespace gno::host {

struct LightGridOptions {
    uint32_t resolution = 64;  ///< cells along an edge of a face
    uint32_t nest = 8;         ///< a cell with more casters gets 8 x 8 sub cells; 0: none does
    bool viewCull = true, cover = true;
    uint32_t pool = 0;   ///< pairs of cell and caster, and items of lists; 0: as many as the frame needs, which two read-backs tell
    bool planes = true;  ///< a query asks the casters' planes first, 64 bytes each
    uint32_t repeat = 1;
    bool warmUp = true;
};

class LightGridLists {
public:
    /// Throws InputError when an array would pass the device's limits, or the given pool is too small.
    LightGridLists(const FrameInputs& inputs, const LightGridOptions& options);

    [[nodiscard]] std::vector<Binding> resources() const;  ///< what a query binds, its own images left out
    [[nodiscard]] const std::vector<RecordPass>& passes() const { return passes_; }
    [[nodiscard]] uint32_t pairs() const { return pairs_; }
    [[nodiscard]] uint32_t items() const { return items_; }
    [[nodiscard]] uint32_t nests() const { return nests_; }
    [[nodiscard]] NamedNumbers bytes() const;
    [[nodiscard]] std::vector<DumpedBuffer> dump() const;

private:
    void recordCells(Recording& recording) const;
    void recordCounts(Recording& recording) const;
    void recordItems(Recording& recording) const;
    void run(Recording& recording, const std::string& shader, uint32_t groups, Specialization constants = {}) const;
    void runIndirect(Recording& recording, const std::string& shader, const Buffer& header, uint64_t offset, Specialization constants = {}) const;
    [[nodiscard]] const ComputePass& pass(const std::string& shader, Specialization constants) const;

    const FrameInputs& inputs_;
    LightGridOptions options_;
    CellAssignment assignment_;
    uint32_t pairs_ = 0, items_ = 0, nests_ = 0;
    Buffer lists_, depths_, itemPool_, header_, planes_;
    std::vector<RecordPass> passes_;
};

}  // namespace gno::host
