// SPDX-License-Identifier: MIT
// A light-space bounding volume hierarchy on the device, built with glsl/rivals/light_bvh_build.glsl and glsl/core/radix_sort.glsl as any engine
// would.
#pragma once
#include <vector>

#include "glsl/rivals/light_bvh.h"
#include "host_min/output/record.hpp"
#include "host_min/techniques/technique.hpp"

namespace gno::host {

struct LightBvhOptions {
    uint32_t pool = 0;  ///< references; 0: as many as the frame needs, which one read-back tells
    uint32_t repeat = 1;
    bool warmUp = true;
};

class LightBvhTree {
public:
    /// Throws InputError when an array would pass the device's limits, or the given pool is too small.
    LightBvhTree(const FrameInputs& inputs, const LightBvhOptions& options);

    [[nodiscard]] std::vector<Binding> resources() const;  ///< what a query binds, its own images left out
    [[nodiscard]] const std::vector<RecordPass>& passes() const { return passes_; }
    [[nodiscard]] uint32_t references() const { return references_; }
    [[nodiscard]] uint32_t nodes() const { return nodeCount_; }
    [[nodiscard]] uint32_t levels() const { return levelCount_; }
    [[nodiscard]] NamedNumbers bytes() const;
    [[nodiscard]] std::vector<DumpedBuffer> dump() const;

private:
    void recordCount(Recording& recording) const;
    void recordTree(Recording& recording) const;
    void recordSort(Recording& recording) const;
    [[nodiscard]] std::vector<Binding> buildResources() const;
    [[nodiscard]] const ComputePass& pass(const std::string& name) const;

    const FrameInputs& inputs_;
    uint32_t references_ = 0, nodeCount_ = 0, levelCount_ = 0;
    Buffer grid_, header_, masks_, sums_, levels_, referenceList_, keys_, order_, otherKeys_, otherOrder_, counts_, boxes_, splits_, nodes_,
        parents_;
    std::vector<RecordPass> passes_;
};

}  // namespace gno::host
