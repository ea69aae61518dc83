// SPDX-License-Identifier: MIT
#include "host_min/techniques/top_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host_min/error.hpp"
#include "host_min/techniques/measure.hpp"

namespace gno::host {
namespace {

/// At least one: set-up writes the header of an empty tree too.
uint32_t groupCount(const DeviceFacts& device, uint32_t triangles, uint32_t groupSize) {
    if (groupSize > device.maxComputeWorkGroupInvocations)
        throw InputError(
            fmt::format("--set group={}: the device's maxComputeWorkGroupInvocations is {}", groupSize, device.maxComputeWorkGroupInvocations));
    const uint32_t groups = std::max(1u, (triangles + groupSize - 1) / groupSize);
    if (groups > kMostGroups)
        throw InputError(fmt::format("--set group={}: {} triangles would need {} work groups, over the limit of {}; use at least {}", groupSize,
                                     triangles, groups, kMostGroups, (triangles + kMostGroups - 1) / kMostGroups));
    return groups;
}

}  // namespace

TopTree::TopTree(const FrameInputs& inputs, const TopTreeOptions& options)
    : planes_(inputs.device(), topPlaneBytes(inputs.triangleCount())),
      links_(inputs.device(), topLinkBytes(inputs.triangleCount())),
      header_(inputs.device(), sizeof(GnoTopHeader)) {
    if (options.counters) {
        Buffer totals(inputs.device(), 5 * 4);
        totals.fill(0);
        Recording recording(inputs.device());
        record(recording, inputs, options, &totals);
        recording.submit();
        const auto words = totals.downloadAs<uint32_t>();
        counters_ = {uint64_t(words[1]) << 32 | words[0], words[2], words[3], words[4]};
    }
    passes_.push_back({inputs.casterSetUp().name, inputs.casterSetUp().ms});
    for (const PassTime& pass : measure(inputs.device(), options.repeat, options.warmUp, [&](Recording& r) { record(r, inputs, options, nullptr); }))
        passes_.push_back({pass.name, pass.ms});
}

uint64_t TopTree::bytes() const { return planes_.bytes() + links_.bytes() + header_.bytes(); }

void TopTree::record(Recording& recording, const FrameInputs& inputs, const TopTreeOptions& options, const Buffer* totals) const {
    const Specialization constants{{0, uint32_t(options.precision)}, {10, options.groupSize}};
    const std::string suffix = totals ? ".counters" : "";
    const ComputePass& setUp = inputs.passes().compute("top/examples/set_up.comp" + suffix, constants);
    const ComputePass& build = inputs.passes().compute("top/examples/build.comp" + suffix, constants);
    const ExamplePush push = inputs.push(options.seed);
    const auto bytes = std::as_bytes(std::span(&push, 1));
    const uint32_t groups = groupCount(inputs.device().facts(), inputs.triangleCount(), options.groupSize);
    const std::array resources{Binding{"gnoCasters", &inputs.casters()}, Binding{"gnoStates", &inputs.states()},
                               Binding{"gnoTopPlanes", &planes_},        Binding{"gnoTopLinks", &links_},
                               Binding{"gnoTopHeader", &header_},        Binding{"gnoTotals", totals ? totals : &header_}};
    recording.beginPass("top_setup");
    setUp.dispatch(recording, resources, bytes, groups);
    recording.endPass();
    recording.beginPass("top_build");
    build.dispatch(recording, resources, bytes, groups);
    recording.endPass();
}

}  // namespace gno::host
