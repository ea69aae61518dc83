// SPDX-License-Identifier: MIT
#include "host_min/techniques/top_tree.hpp"

#include <fmt/format.h>

#include "host_min/error.hpp"
#include "host_min/techniques/build_totals.hpp"

namespace gno::host {

std::string topOverLimit(const DeviceFacts& device, const FrameLoad& load, const TopOptions& options) {
    const uint32_t size = options.groupSize;
    if (size > device.maxComputeWorkGroupInvocations)
        return fmt::format("--set group={}: the device's maxComputeWorkGroupInvocations is {}", size, device.maxComputeWorkGroupInvocations);
    if (load.triangles > uint64_t(size) * kMostGroups)
        return fmt::format("--set group={}: {} triangles would need {} work groups, over the limit of {}; use at least {}", size, load.triangles,
                           groupsFor(load.triangles, size), kMostGroups, (load.triangles + kMostGroups - 1) / kMostGroups);
    return overCasters(load.triangles, device.maxStorageBufferRange / 64, "64 bytes each in one array, the device's maxStorageBufferRange");
}

void TopTree::prepare(const FrameInputs& inputs) {
    throwLimit(topOverLimit(inputs.device().facts(), FrameLoad::of(inputs), options_));
    inputs_ = &inputs;
    arrays_.fit(inputs.device(), topArrays(inputs.triangleCount()));
    passes_ = PassRunner(inputs.passes(), topBuildPasses(inputs.triangleCount(), options_), inputs.withCasters(arrays_.bindings()));
}

void TopTree::record(Recording& recording, uint32_t) const { passes_.record(recording, inputs_->push(options_.seed)); }

void TopTree::count() {
    const BuildTotals totals(inputs_->device());
    std::vector<Binding> resources = inputs_->withCasters(arrays_.bindings());
    resources.push_back(totals.binding());
    const PassRunner counting(inputs_->passes(), passes_.list(), resources, {.counters = true});
    Recording recording(inputs_->device());
    counting.record(recording, inputs_->push(options_.seed));
    recording.submit();
    counters_ = totals.read();
}

}  // namespace gno::host
