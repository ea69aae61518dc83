// SPDX-License-Identifier: MIT
// The kept casters of one frame and light in acceleration structures on the device: indices into the casters' buffer, a bottom level, a
// top level that holds it once.
#pragma once
#include <vector>

#include "host_min/techniques/technique.hpp"
#include "host_min/vulkan/acceleration_structure.hpp"

namespace gno::host {

class RayScene {
public:
    /// Builds, `repeat` times for the times. The device has ray queries.
    RayScene(const FrameInputs& inputs, uint32_t repeat, bool warmUp);

    [[nodiscard]] const Buffer& indices() const { return indices_; }
    [[nodiscard]] const AccelerationStructure& top() const { return top_; }
    [[nodiscard]] const std::vector<RecordPass>& passes() const { return passes_; }  ///< caster_setup, ray_setup, bottom_build, top_level_build
    [[nodiscard]] NamedNumbers bytes() const;

private:
    void record(Recording& recording, const FrameInputs& inputs) const;

    Buffer indices_;
    AccelerationStructure bottom_, top_;
    std::vector<RecordPass> passes_;
};

}  // namespace gno::host
