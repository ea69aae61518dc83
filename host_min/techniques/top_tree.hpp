// SPDX-License-Identifier: MIT
// A TOP tree on the device, built with glsl/top as any engine would.
#pragma once
#include <vector>

#include "glsl/top/node.h"
#include "host_min/output/record.hpp"
#include "host_min/techniques/technique.hpp"

namespace gno::host {

struct TopTreeOptions {
    Precision precision = Precision::certified;
    uint32_t seed = 1;  ///< of the insertion order
    uint32_t groupSize = kTopGroupSize;
    uint32_t repeat = 1;
    bool warmUp = true;
    bool counters = true;
};

struct TopBuildCounters {
    uint64_t steps = 0, intersections = 0, dropped = 0, inserted = 0;
};

class TopTree {
public:
    TopTree(const FrameInputs& inputs, const TopTreeOptions& options);

    [[nodiscard]] const Buffer& planes() const { return planes_; }
    [[nodiscard]] const Buffer& links() const { return links_; }
    [[nodiscard]] const Buffer& header() const { return header_; }
    [[nodiscard]] const std::vector<RecordPass>& passes() const { return passes_; }  ///< caster_setup, top_setup, top_build
    [[nodiscard]] const TopBuildCounters& counters() const { return counters_; }
    [[nodiscard]] uint64_t bytes() const;

private:
    void record(Recording& recording, const FrameInputs& inputs, const TopTreeOptions& options, const Buffer* totals) const;

    Buffer planes_, links_, header_;
    std::vector<RecordPass> passes_;
    TopBuildCounters counters_;
};

}  // namespace gno::host
