// SPDX-License-Identifier: MIT
#include "host_min/techniques/top_tree.hpp"

#include <fmt/format.h>

#include "host_min/error.hpp"
#include "host_min/techniques/build_totals.hpp"

namespace gno::host {
namespace {

void checkGroups(const DeviceFacts& device, uint32_t triangles, uint32_t groupSize) {
    if (groupSize > device.maxComputeWorkGroupInvocations)
        throw InputError(
            fmt::format("--set group={}: the device's maxComputeWorkGroupInvocations is {}", groupSize, device.maxComputeWorkGroupInvocations));
    const uint32_t groups = groupsFor(triangles, groupSize);
    if (groups > kMostGroups)
        throw InputError(fmt::format("--set group={}: {} triangles would need {} work groups, over the limit of {}; use at least {}", groupSize,
                                     triangles, groups, kMostGroups, (triangles + kMostGroups - 1) / kMostGroups));
}

}  // namespace

void TopTree::prepare(const FrameInputs& inputs) {
    checkGroups(inputs.device().facts(), inputs.triangleCount(), options_.groupSize);
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
