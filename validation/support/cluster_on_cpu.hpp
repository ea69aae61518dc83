// SPDX-License-Identifier: MIT
// The cluster family on the CPU, in one thread with subgroups of one lane, made of the same GLSL text that the device runs: build, volumes,
// traversal, merge. Work groups with barriers run as coroutines. A variant is one compilation of cluster_on_cpu.cpp, as with top_on_cpu.hpp.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "validation/support/camera_view.hpp"

namespace gno::cpu {

struct ClusterChoice {
    uint32_t precision, form, split, jobCapacity, boxCapacity;
    bool extraPlanes;
};

class ClusterFamily {
public:
    virtual ~ClusterFamily() = default;

    /// One frame: GNO_VISIBILITY_* per pixel. Arrays are as the frame before left them. Throws std::runtime_error when the text leaves its arrays or
    /// does not end.
    virtual std::vector<uint32_t> run(const test::CameraView& view, const ClusterChoice& choice) = 0;
};

struct ClusterVariant {
    std::string name;
    std::unique_ptr<ClusterFamily> (*make)();
};

/// All variants that this program is linked with.
inline std::vector<ClusterVariant>& clusterVariants() {
    static std::vector<ClusterVariant> variants;
    return variants;
}

}  // namespace gno::cpu
