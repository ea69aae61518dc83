// SPDX-License-Identifier: MIT
#include "host_min/techniques/ray_scene.hpp"

#include <array>

#include "host_min/techniques/measure.hpp"

namespace gno::host {
namespace {
constexpr uint32_t kGroup = 64;  // of ray_set_up.comp
}

RayScene::RayScene(const FrameInputs& inputs, uint32_t repeat, bool warmUp)
    : indices_(inputs.device(), uint64_t(inputs.triangleCount()) * 12, vk::BufferUsageFlagBits::eStorageBuffer | AccelerationStructure::kInputUsage),
      bottom_(AccelerationStructure::ofTriangles(inputs.device(), inputs.casters(), indices_, inputs.triangleCount())),
      top_(AccelerationStructure::ofInstance(inputs.device(), bottom_)) {
    passes_.push_back({inputs.casterSetUp().name, inputs.casterSetUp().ms});
    for (const PassTime& pass : measure(inputs.device(), repeat, warmUp, [&](Recording& r) { record(r, inputs); }))
        passes_.push_back({pass.name, pass.ms});
}

NamedNumbers RayScene::bytes() const {
    return {{"indices", indices_.bytes()},
            {"bottom_level", bottom_.bytes()},
            {"top_level", top_.bytes()},
            {"build_scratch", bottom_.scratchBytes() + top_.scratchBytes()}};
}

void RayScene::record(Recording& recording, const FrameInputs& inputs) const {
    const ExamplePush push = inputs.push();
    const std::array resources{Binding{"gnoStates", &inputs.states()}, Binding{"gnoRayIndices", &indices_}};
    recording.beginPass("ray_setup");
    inputs.passes()
        .compute("rivals/examples/ray_set_up.comp")
        .dispatch(recording, resources, std::as_bytes(std::span(&push, 1)), (inputs.triangleCount() + kGroup - 1) / kGroup);
    recording.endPass();
    recording.beginPass("bottom_build");
    bottom_.build(recording);
    recording.endPass();
    recording.beginPass("top_level_build");
    top_.build(recording);
    recording.endPass();
}

}  // namespace gno::host
