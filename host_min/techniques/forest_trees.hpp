// SPDX-License-Identifier: MIT
// A forest of TOP trees on the device, one per cell of the light's grid, built by the pass lists of glsl/forest/passes.hpp.
#pragma once
#include <optional>
#include <vector>

#include "host_min/output/record.hpp"
#include "host_min/techniques/array_buffers.hpp"
#include "host_min/techniques/cell_assignment.hpp"
#include "host_min/techniques/technique.hpp"
#include "host_min/techniques/top_tree.hpp"

namespace gno::host {

enum class CellChoice : uint8_t {
    given,    ///< ForestSettings::resolution
    known,    ///< forestResolution(), before the frame
    counted,  ///< counting at several, within the frame: the host waits for each
};

struct ForestSettings {
    ForestOptions options;
    CellChoice choice = CellChoice::known;
    uint32_t resolution = 0;
    bool viewCull = true, cover = true;
    uint32_t pool = 0;  ///< pairs; 0: chosen, and enlarged when it was too small
};

class ForestTrees final : public Structure {
public:
    explicit ForestTrees(const ForestSettings& settings) : settings_(settings) {}

    void prepare(const FrameInputs& inputs) override;
    [[nodiscard]] uint32_t segments() const override { return segments_; }
    void record(Recording& recording, uint32_t segment) const override;
    void between(uint32_t segment) override;
    void count() override;
    /// Throws InputError when the device has no room for the pairs, or the given pool has none.
    [[nodiscard]] bool read() override;

    [[nodiscard]] std::vector<Binding> bindings() const { return arrays_.bindings(); }  ///< what a query binds, its own images left out
    [[nodiscard]] const ForestOptions& options() const { return settings_.options; }
    [[nodiscard]] const TopBuildCounters& counters() const { return counters_; }
    [[nodiscard]] uint32_t resolution() const { return cells_.resolution; }
    [[nodiscard]] const GnoForestHeader& found() const { return found_; }  ///< pairs, used cells, casters with some and with many cells
    [[nodiscard]] NamedNumbers bytes() const;
    [[nodiscard]] std::vector<DumpedBuffer> dump() const;

private:
    /// Counting at one resolution, with a grid and cells of its own.
    struct Candidate {
        uint32_t resolution;
        Buffer grid;
        PassRunner passes;
    };
    [[nodiscard]] uint64_t mostPairs() const { return forestMostPairs(inputs_->device().facts().maxStorageBufferRange); }
    [[nodiscard]] uint64_t poolBefore() const;
    void prepareBuild(uint32_t resolution, uint64_t pool);
    void prepareCandidates();
    [[nodiscard]] GnoForestHeader header() const { return arrays_["gnoForestHeader"].downloadAs<GnoForestHeader>().front(); }

    ForestSettings settings_;
    const FrameInputs* inputs_ = nullptr;
    LightCells cells_;
    ArrayBuffers arrays_;
    PassRunner passes_;
    uint32_t segments_ = 1;
    std::vector<Candidate> candidates_;
    std::optional<Buffer> candidateCells_, candidatePairs_;
    std::vector<double> costs_;      ///< of the candidates that were counted
    std::vector<uint32_t> counted_;  ///< their pairs
    GnoForestHeader found_{};        ///< what the assignment counted
    uint64_t learned_ = 0;           ///< pairs of the frame before
    TopBuildCounters counters_;
};

}  // namespace gno::host
