// SPDX-License-Identifier: MIT
#include "host_min/techniques/cluster_hierarchy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "host_min/error.hpp"
#include "host_min/techniques/cluster_frame.hpp"

namespace gno::host {

std::string clusterOverLimit(const DeviceFacts& device, const FrameLoad& load, const ClusterOptions& options) {
    const uint64_t limit = device.maxStorageBufferRange;
    const ClusterLayout layout = clusterLayout(load.width, load.height, options.form);
    const uint64_t bounds = clusterBoxes(layout, options) * clusterBoxBytes(layout.form);
    const bool compact = layout.form == ClusterForm::compact;
    if (bounds > limit)
        return fmt::format(
            "--set bounds={}: at {}x{} an array of bounds takes {} bytes, over the device's maxStorageBufferRange of {}: use --set bounds=compact{}",
            compact ? "compact" : "explicit", load.width, load.height, bounds, limit, compact ? " with a smaller boxes" : "");
    const uint64_t sums = options.layers ? 16 * uint64_t(load.width) * load.height : 0;
    if (sums > limit)
        return fmt::format(
            "{}x{}: what casters let through takes {} bytes, over the device's maxStorageBufferRange of {}: use a smaller --size, or "
            "--set materials=off",
            load.width, load.height, sums, limit);
    const uint64_t most = clusterMostCasters(limit);
    return overCasters(load.triangles, most,
                       most == limit / 112 ? fmt::format("112 bytes each in one array, the device's maxStorageBufferRange of {}", limit)
                                           : std::string("64 in each of 65535 work groups"));
}

void ClusterHierarchy::prepare(const FrameInputs& inputs) {
    inputs_ = &inputs;
    throwLimit(clusterOverLimit(inputs.device().facts(), FrameLoad::of(inputs), options_));
    layout_ = clusterLayout(inputs.width(), inputs.height(), options_.form);
    arrays_.fit(inputs.device(), clusterArrays(inputs.width(), inputs.height(), inputs.triangleCount(), options_));
    const bool frontCulled = (inputs.push().cull & uint32_t(Cull::front)) != 0;
    const ClusterUniform uniform =
        clusterUniform(clusterFrame(inputs.frame().camera, inputs.width(), inputs.height()), inputs.triangleCount(), frontCulled, options_);
    arrays_["gnoClusterFrame"].upload(std::as_bytes(std::span(&uniform, 1)));
    passes_ = PassRunner(inputs.passes(), clusterBuildPasses(inputs.width(), inputs.height(), inputs.triangleCount(), options_),
                         inputs.withCasters(bindings()));
}

void ClusterHierarchy::record(Recording& recording, uint32_t) const { passes_.record(recording, inputs_->push()); }

std::vector<Binding> ClusterHierarchy::bindings() const {
    std::vector<Binding> all = arrays_.bindings();
    if (!options_.layers) return all;
    const MaterialBuffers& materials = inputs_->materials();
    for (const Binding& more : {Binding{"gnoMaterialOf", &materials.of()}, Binding{"gnoSurfaces", &materials.surfaces()},
                                Binding{"gnoMaterials", &materials.list()}, Binding{"gnoTexels", &materials.texels()}})
        all.push_back(more);
    return all;
}

void ClusterHierarchy::run(const PassList& list, std::span<const Binding> more, bool counters) const {
    std::vector<Binding> resources = inputs_->withCasters(bindings());
    resources.insert(resources.end(), more.begin(), more.end());
    const PassRunner runner(inputs_->passes(), list, resources, {.counters = counters});
    Recording recording(inputs_->device());
    runner.record(recording, inputs_->push());
    recording.submit();
}

uint32_t ClusterHierarchy::occupied() const {
    uint32_t count = 0;
    const auto words = arrays_["gnoClusterMasks"].downloadAs<uint32_t>();  // the buffer may be longer: what follows the last word is nobody's
    for (uint32_t i = 0; i < clusterWordCount(layout_); ++i) count += uint32_t(std::popcount(words[i]));
    return count;
}

void ClusterHierarchy::count() {
    constexpr uint32_t kTotals = 5;
    const uint32_t width = inputs_->width(), height = inputs_->height(), casters = inputs_->triangleCount();
    counters_ = {};
    run(clusterHierarchyPasses(width, height, options_));  // the traversal clears bits, so the tree is looked at before it
    counters_.occupiedNodes = occupied();
    counters_.boxes = header().boxCount;

    Buffer totals(inputs_->device(), 8 * kTotals),
        steps(inputs_->device(), 4 * std::max<uint64_t>(casters, options_.split > 0 ? options_.jobCapacity : 0));
    Image counts(inputs_->device(), width, height, vk::Format::eR32Uint);
    totals.fill(0);
    steps.fill(0);
    counts.clear(vk::ClearColorValue(0u, 0u, 0u, 0u));
    const std::array bound{Binding{"gnoTotals", &totals}, Binding{"gnoSteps", &steps}, Binding{"gnoCounts", &counts}};
    const auto stepsOf = [&](uint32_t jobs) {
        std::vector<uint32_t> all = steps.downloadAs<uint32_t>();
        all.resize(jobs);
        steps.fill(0);
        return all;
    };
    run(clusterVolumePasses(width, height, casters, options_));
    run(clusterExpandPasses(options_), bound, true);  // apart from the second pass: both write gnoSteps
    counters_.expandSteps = stepsOf(casters);
    counters_.jobs = header().jobCount;
    if (options_.split > 0) {
        run(clusterFinishPasses(options_), bound, true);
        counters_.finishSteps = stepsOf(std::min(counters_.jobs, options_.jobCapacity));
    }
    const auto words = totals.downloadAs<uint32_t>();
    const auto total = [&](uint32_t at) { return uint64_t(words[2 * at + 1]) << 32 | words[2 * at]; };
    counters_.nodeTests = total(0);
    counters_.planeTests = total(1);
    counters_.leafTests = total(2);
    counters_.exactCalls = total(3);
    counters_.accepted = total(4);
    counters_.testsOfPixel = counts.downloadAs<uint32_t>();
    run(passes_.list());
}

}  // namespace gno::host
