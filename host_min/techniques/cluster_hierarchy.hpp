// SPDX-License-Identifier: MIT
// A view-sample cluster hierarchy with all shadow volumes sent through it, built by the pass list of glsl/clusters/passes.hpp.
#pragma once
#include <vector>

#include "glsl/clusters/cluster.h"
#include "glsl/clusters/passes.hpp"
#include "host_min/techniques/array_buffers.hpp"
#include "host_min/techniques/technique.hpp"

namespace gno::host {

/// Of the instrumented run.
struct ClusterCounters {
    uint64_t nodeTests = 0, planeTests = 0, leafTests = 0, exactCalls = 0, accepted = 0;
    uint64_t occupiedNodes = 0;                      ///< of the tree, the root left out
    uint32_t jobs = 0, boxes = 0;                    ///< asked for; more than the capacity: the rest was done without
    std::vector<uint32_t> expandSteps, finishSteps;  ///< iterations of each job of either pass
    std::vector<uint32_t> testsOfPixel;              ///< samples tested, per pixel
};

/// Which limit of the device a frame would pass, and what to do; empty: none.
std::string clusterOverLimit(const DeviceFacts& device, const FrameLoad& load, const ClusterOptions& options);

class ClusterHierarchy final : public Structure {
public:
    /// With layers, the inputs have materials.
    explicit ClusterHierarchy(const ClusterOptions& options) : options_(options) {}

    /// Throws LimitError when an array of this form would pass the device's limits; the text names a form that fits.
    void prepare(const FrameInputs& inputs) override;
    void record(Recording& recording, uint32_t segment) const override;
    /// Ends with the plain passes, whose answer is the one that is asked.
    void count() override;

    [[nodiscard]] const ClusterOptions& options() const { return options_; }
    [[nodiscard]] const ClusterLayout& layout() const { return layout_; }
    [[nodiscard]] const ClusterCounters& counters() const { return counters_; }
    [[nodiscard]] std::vector<Binding> bindings() const;  ///< materials included, with layers

    /// Per pixel, after the query; with layers only (TechniqueResult::sums).
    [[nodiscard]] std::vector<glm::uvec3> sums() const;
    [[nodiscard]] NamedNumbers bytes() const;
    /// Runs the hierarchy's passes alone in between, for its masks before the traversal; all of them at the end.
    [[nodiscard]] std::vector<DumpedBuffer> dump() const;

private:
    void run(const PassList& list, std::span<const Binding> more = {}, bool counters = false) const;
    [[nodiscard]] GnoClusterHeader header() const { return arrays_["gnoClusterHeader"].downloadAs<GnoClusterHeader>().front(); }
    [[nodiscard]] uint32_t occupied() const;

    ClusterOptions options_;
    ClusterLayout layout_;
    const FrameInputs* inputs_ = nullptr;
    ArrayBuffers arrays_;
    PassRunner passes_;
    ClusterCounters counters_;
};

}  // namespace gno::host
