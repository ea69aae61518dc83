// SPDX-License-Identifier: MIT
// The arrays of a view-sample cluster hierarchy and its passes, run with glsl/clusters as any engine would.
#pragma once
#include <string>
#include <vector>

#include "glsl/clusters/cluster.h"
#include "host_min/techniques/technique.hpp"

namespace gno::host {

struct ClusterOptions {
    Precision precision = Precision::certified;
    uint32_t form = GNO_CLUSTER_COMPACT;  ///< GNO_CLUSTER_IMPLICIT, ...
    uint32_t split = 0;                   ///< depth at which the first pass leaves jobs, 0: one pass
    bool extraPlanes = true;
    uint32_t groups = 64;  ///< work groups of the traversal
    uint32_t jobCapacity = 1u << 20;
    uint32_t boxCapacity = 1u << 19;  ///< compact only
    bool layers = false;              ///< look up what casters let through; the inputs have materials
};

/// Of the instrumented run.
struct ClusterCounters {
    uint64_t nodeTests = 0, planeTests = 0, leafTests = 0, exactCalls = 0, accepted = 0;
    uint64_t occupiedNodes = 0;                      ///< of the tree, the root left out
    uint32_t jobs = 0, boxes = 0;                    ///< asked for; more than the capacity: the rest was done without
    std::vector<uint32_t> expandSteps, finishSteps;  ///< iterations of each job of either pass
    std::vector<uint32_t> testsOfPixel;              ///< samples tested, per pixel
};

/// The contract's camera: GnoClusterFrame but for what ClusterOptions tells.
GnoClusterFrame clusterFrame(const Camera& camera, uint32_t width, uint32_t height);

class ClusterHierarchy {
public:
    /// Allocates. Throws InputError when an array of this form would pass the device's limits; the text names a form that fits.
    ClusterHierarchy(const FrameInputs& inputs, const ClusterOptions& options);

    /// Records all passes of one frame, the answer included.
    void record(Recording& recording, const Image& visibility) const;

    /// The hierarchy alone, without shadow volumes; record() holds it.
    void recordBuild(Recording& recording) const;

    /// Runs the instrumented variant once, the answer included.
    [[nodiscard]] ClusterCounters count(const Image& visibility);

    /// Per pixel, after a run; with layers only (TechniqueResult::sums).
    [[nodiscard]] std::vector<glm::uvec3> sums() const;

    [[nodiscard]] const GnoClusterLayout& layout() const { return layout_; }
    [[nodiscard]] NamedNumbers bytes() const;
    /// After a run. Builds the hierarchy again at the end, for its masks before the traversal.
    [[nodiscard]] std::vector<DumpedBuffer> dump() const;

private:
    [[nodiscard]] std::vector<Binding> resources(const Image* visibility) const;
    void recordSetUp(Recording& recording) const;
    void recordPass(Recording& recording, uint32_t which, bool counters) const;  ///< 1: expand, 2: finish
    void recordMerge(Recording& recording, const Image& visibility) const;
    [[nodiscard]] const ComputePass& pass(const std::string& name, uint32_t what = 3, uint32_t which = 1) const;
    [[nodiscard]] uint32_t occupied() const;

    const FrameInputs& inputs_;
    ClusterOptions options_;
    GnoClusterLayout layout_;
    Buffer frame_, header_, slices_, masks_, shade_, low_, high_, pointers_, volumes_, info_, jobs_, sums_;
    Buffer totals_, steps_;
    Image counts_;
};

}  // namespace gno::host
