// SPDX-License-Identifier: MIT
// The kept casters of one frame and light in acceleration structures on the device, built by the pass list of glsl/rivals/ray_query_passes.hpp.
#pragma once
#include <optional>
#include <vector>

#include "glsl/rivals/ray_query_passes.hpp"
#include "host_min/frame/pass_runner.hpp"
#include "host_min/techniques/array_buffers.hpp"
#include "host_min/techniques/structure.hpp"
#include "host_min/vulkan/acceleration_structure.hpp"

namespace gno::host {

class RayScene final : public Structure {
public:
    /// The device has ray queries.
    void prepare(const FrameInputs& inputs) override;
    void record(Recording& recording, uint32_t segment) const override;

    [[nodiscard]] std::vector<Binding> bindings() const;
    [[nodiscard]] const Buffer& indices() const { return arrays_["gnoRayIndices"]; }
    [[nodiscard]] NamedNumbers bytes() const;
    /// For a runner of rayQueryBuildPasses: the two builds.
    void recordCommand(Recording& recording, const Pass& pass) const;

private:
    const FrameInputs* inputs_ = nullptr;
    ArrayBuffers arrays_;
    std::optional<AccelerationStructure> bottom_, top_;
    PassRunner passes_;
};

}  // namespace gno::host
