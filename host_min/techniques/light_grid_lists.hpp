// SPDX-License-Identifier: MIT
// Lists of casters per cell of the light's grid on the device, built by the pass lists of glsl/rivals/light_grid_passes.hpp.
#pragma once
#include <vector>

#include "glsl/rivals/light_grid.h"
#include "glsl/rivals/light_grid_passes.hpp"
#include "host_min/output/record.hpp"
#include "host_min/techniques/array_buffers.hpp"
#include "host_min/techniques/cell_assignment.hpp"
#include "host_min/techniques/technique.hpp"

namespace gno::host {

struct LightGridSettings {
    LightGridOptions options;
    uint32_t resolution = 64;  ///< cells along an edge of a face
    bool viewCull = true, cover = true;
    uint32_t pool = 0;  ///< pairs of cell and caster, and items of lists; 0: chosen, and enlarged when they were too small
};

class LightGridLists final : public Structure {
public:
    explicit LightGridLists(const LightGridSettings& settings) : settings_(settings) {}

    void prepare(const FrameInputs& inputs) override;
    void record(Recording& recording, uint32_t segment) const override;
    /// Throws InputError when the device has no room for pairs or items, or the given pool has none.
    [[nodiscard]] bool read() override;

    [[nodiscard]] std::vector<Binding> bindings() const { return arrays_.bindings(); }  ///< what a query binds, its own images left out
    [[nodiscard]] const LightGridOptions& options() const { return settings_.options; }
    [[nodiscard]] uint32_t pairs() const { return pairs_; }
    [[nodiscard]] uint32_t items() const { return items_; }
    [[nodiscard]] uint32_t nests() const { return nests_; }      ///< cells that have sub cells
    [[nodiscard]] uint32_t crowded() const { return crowded_; }  ///< cells that should have sub cells and found no room
    [[nodiscard]] NamedNumbers bytes() const;
    [[nodiscard]] std::vector<DumpedBuffer> dump() const;

private:
    [[nodiscard]] uint64_t most() const { return inputs_->device().facts().maxStorageBufferRange / 16 * 2; }  ///< entries of a pool in one binding

    LightGridSettings settings_;
    const FrameInputs* inputs_ = nullptr;
    LightCells cells_;
    LightGridPools pools_;
    ArrayBuffers arrays_;
    PassRunner passes_;
    uint32_t pairs_ = 0, items_ = 0, nests_ = 0, crowded_ = 0;
};

}  // namespace gno::host
