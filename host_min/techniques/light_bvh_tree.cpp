// SPDX-License-Identifier: MIT
#include "host_min/techniques/light_bvh_tree.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_min/error.hpp"
#include "host_min/techniques/cell_assignment.hpp"
#include "host_min/techniques/dumped.hpp"

namespace gno::host {

std::string lightBvhOverLimit(const DeviceFacts&, const FrameLoad& load) {
    return overCasters(load.triangles, uint64_t(kMostGroups) * GNO_LIGHT_BVH_GROUP,
                       fmt::format("{} in each of {} work groups", GNO_LIGHT_BVH_GROUP, kMostGroups));
}

void LightBvhTree::prepare(const FrameInputs& inputs) {
    throwLimit(lightBvhOverLimit(inputs.device().facts(), FrameLoad::of(inputs)));
    inputs_ = &inputs;
    const uint64_t most = lightBvhMostReferences(inputs.device().facts().maxStorageBufferRange);
    const uint64_t first = std::max(lightBvhFirstPool(inputs.casterCount(), inputs.light().w == 0), wanted_);
    pool_ = options_.pool > 0 ? options_.pool : std::max(pool_, std::min(first, most));
    arrays_.fit(inputs.device(), lightBvhArrays(inputs.triangleCount(), pool_));
    const GnoForestGrid grid = forestGrid(inputs.light(), inputs.frame().low, inputs.frame().high, GNO_LIGHT_BVH_RESOLUTION);
    arrays_["gnoLightBvhGrid"].upload(std::span(&grid, 1));
    passes_ = PassRunner(inputs.passes(), lightBvhBuildPasses(inputs.triangleCount(), pool_), inputs.withCasters(arrays_.bindings()));
}

void LightBvhTree::record(Recording& recording, uint32_t) const { passes_.record(recording, inputs_->push()); }

bool LightBvhTree::read() {
    references_ = arrays_["gnoLightBvhHeader"].downloadAs<GnoLightBvhHeader>().front().references;
    if (inputs_->light().w != 0) wanted_ = references_ + references_ / 4;
    if (references_ > pool_) {
        const uint64_t most = lightBvhMostReferences(inputs_->device().facts().maxStorageBufferRange);
        if (references_ > most)
            throw LimitError(
                fmt::format("the light-space hierarchy needs {} references, over the limit of {}: use another technique", references_, most));
        if (options_.pool > 0)
            throw InputError(
                fmt::format("--set pool={}: the light-space hierarchy needs {} references: use a larger pool, or 0", options_.pool, references_));
        return false;
    }
    nodeCount_ = levelCount_ = 0;
    for (const GnoLightBvhLevel& level : arrays_["gnoLightBvhLevels"].downloadAs<GnoLightBvhLevel>()) {
        nodeCount_ += level.count;
        levelCount_ += level.count > 0;
    }
    return true;
}

NamedNumbers LightBvhTree::bytes() const {
    return {{"nodes", arrays_.bytes({"gnoLightBvhNode", "gnoLightBvhParents"})},
            {"grid", arrays_.bytes({"gnoLightBvhGrid", "gnoLightBvhHeader"})},
            {"build",
             arrays_.bytes({"gnoLightBvhMasks", "gnoLightBvhSums", "gnoLightBvhLevels", "gnoLightBvhReferences", "gnoLightBvhKeys",
                            "gnoLightBvhOrder", "gnoSortedKeys", "gnoSortedOrder", "gnoSortCountWords", "gnoLightBvhBoxes_", "gnoLightBvhSplits"})}};
}

std::vector<DumpedBuffer> LightBvhTree::dump() const {
    return {dumped("grid", "GnoForestGrid", arrays_["gnoLightBvhGrid"], sizeof(GnoForestGrid), 1),
            dumped("light_bvh_header", "GnoLightBvhHeader", arrays_["gnoLightBvhHeader"], sizeof(GnoLightBvhHeader), 1),
            dumped("levels", "GnoLightBvhLevel level[]", arrays_["gnoLightBvhLevels"], sizeof(GnoLightBvhLevel), GNO_LIGHT_BVH_LEVELS),
            dumped("nodes", "GnoLightBvhNode node[]", arrays_["gnoLightBvhNode"], sizeof(GnoLightBvhNode), nodeCount_),
            dumped("parents", "uint parent[]", arrays_["gnoLightBvhParents"], 4, nodeCount_)};
}

}  // namespace gno::host
