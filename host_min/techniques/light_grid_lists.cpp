// SPDX-License-Identifier: MIT
#include "host_min/techniques/light_grid_lists.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_min/error.hpp"
#include "host_min/techniques/dumped.hpp"
#include "host_min/techniques/measure.hpp"

namespace gno::host {
namespace {

uint32_t groupsOf(uint32_t count) { return std::max(1u, (count + GNO_LIGHT_GRID_GROUP - 1) / GNO_LIGHT_GRID_GROUP); }

/// `what` is in the pool of `given` entries (0: of any size), whose entries take 8 bytes.
void checkPool(const DeviceFacts& device, const char* what, uint32_t needed, uint32_t given, uint32_t resolution) {
    const uint64_t most = device.maxStorageBufferRange / 8;
    if (needed > most)
        throw InputError(
            fmt::format("the light grid needs {} {}, over the limit of {}: use a smaller --set cells than {}", needed, what, most, resolution));
    if (given > 0 && given < needed)
        throw InputError(fmt::format("--set pool={}: the light grid needs {} {}: use a larger pool, or 0", given, needed, what));
}

}  // namespace

LightGridLists::LightGridLists(const FrameInputs& inputs, const LightGridOptions& options)
    : inputs_(inputs),
      options_(options),
      assignment_(inputs, "light grid", options.viewCull, options.cover, 0),
      lists_(inputs.device(), 8),
      depths_(inputs.device(), 4),
      itemPool_(inputs.device(), 8),
      header_(inputs.device(), sizeof(GnoLightGridHeader), vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eIndirectBuffer),
      planes_(inputs.device(), options.planes ? 64 * uint64_t(inputs.triangleCount()) : 0) {
    const Device& device = inputs.device();
    assignment_.setResolution(options.resolution);
    const uint32_t cellCount = assignment_.cellCount();
    lists_ = Buffer(device, uint64_t(gnoLightGridLists(cellCount, 0)) * sizeof(GnoLightGridList));
    const auto submit = [&](auto... parts) {
        Recording recording(device);
        (parts(recording), ...);
        recording.submit();
    };
    const auto cells = [&](Recording& recording) { recordCells(recording); };
    const auto counts = [&](Recording& recording) { recordCounts(recording); };

    submit(cells);  // first read-back: pairs, and cells that are to be nested
    pairs_ = assignment_.header().downloadAs<GnoForestHeader>().front().pairs;
    nests_ = header_.downloadAs<GnoLightGridHeader>().front().nests;
    checkPool(device.facts(), "pairs of cell and caster", pairs_, options.pool, options.resolution);
    assignment_.setPool(std::max(options.pool, pairs_));
    lists_ = Buffer(device, (uint64_t(gnoLightGridLists(cellCount, 0)) + uint64_t(GNO_LIGHT_GRID_GROUP) * nests_) * sizeof(GnoLightGridList));
    depths_ = Buffer(device, uint64_t(GNO_LIGHT_GRID_GROUP) * nests_ * 4);

    submit(cells, counts);  // second: items of all lists
    items_ = header_.downloadAs<GnoLightGridHeader>().front().items;
    checkPool(device.facts(), "items of lists", items_, options.pool, options.resolution);
    itemPool_ = Buffer(device, uint64_t(std::max(options.pool, items_)) * sizeof(GnoLightGridItem));

    passes_.push_back({inputs.casterSetUp().name, inputs.casterSetUp().ms});
    for (const PassTime& time : measure(device, options.repeat, options.warmUp, [&](Recording& recording) {
             recordCells(recording);
             recordCounts(recording);
             recordItems(recording);
             if (options.planes) {
                 recording.beginPass("light_grid_setup_planes");
                 run(recording, "rivals/examples/light_grid_planes.comp", groupsOf(inputs.triangleCount()));
                 recording.endPass();
             }
         }))
        passes_.push_back({time.name, time.ms});
}

std::vector<Binding> LightGridLists::resources() const {
    auto all = assignment_.resources();
    all.insert(all.end(), {{"gnoGridLists", &lists_},
                           {"gnoGridItems", &itemPool_},
                           {"gnoGridDepths", &depths_},
                           {"gnoGridHeader", &header_},
                           {"gnoGridPlanes", &planes_}});
    return all;
}

const ComputePass& LightGridLists::pass(const std::string& shader, Specialization constants) const {
    if (shader.ends_with("_pairs.comp")) constants[30] = options_.viewCull;
    if (shader.ends_with("_open.comp")) constants[33] = options_.nest;
    return inputs_.passes().compute(shader, constants);
}

void LightGridLists::run(Recording& recording, const std::string& shader, uint32_t groups, Specialization constants) const {
    const ExamplePush push = inputs_.push();
    recording.barrier();
    pass(shader, std::move(constants)).dispatch(recording, resources(), std::as_bytes(std::span(&push, 1)), groups);
}

void LightGridLists::runIndirect(Recording& recording, const std::string& shader, const Buffer& header, uint64_t offset,
                                 Specialization constants) const {
    const ExamplePush push = inputs_.push();
    recording.barrier();
    pass(shader, std::move(constants)).dispatchIndirect(recording, resources(), std::as_bytes(std::span(&push, 1)), header, offset);
}

void LightGridLists::recordCells(Recording& recording) const {
    recording.beginPass("light_grid_setup_depth");
    assignment_.recordDepth(recording);
    run(recording, "rivals/examples/light_grid_reset.comp", 1);
    recording.barrier();
    assignment_.recordSort(recording);
    recording.endPass();
    recording.beginPass("light_grid_setup_count");
    assignment_.recordCount(recording);
    run(recording, "rivals/examples/light_grid_open.comp", groupsOf(assignment_.cellCount()));
    run(recording, "rivals/examples/light_grid_sizes.comp", 1);
    recording.endPass();
}

void LightGridLists::recordCounts(Recording& recording) const {
    const ExamplePush push = inputs_.push();
    recording.beginPass("light_grid_setup_pairs");
    assignment_.recordEmit(recording);
    recording.endPass();
    recording.beginPass("light_grid_setup_nest");
    if (nests_ > 0) {
        if (options_.viewCull)
            pass("rivals/examples/light_grid_depth.comp", {})
                .dispatch(recording, resources(), std::as_bytes(std::span(&push, 1)), (inputs_.width() + 7) / 8, (inputs_.height() + 7) / 8);
        runIndirect(recording, "rivals/examples/light_grid_pairs.comp", header_, offsetof(GnoLightGridHeader, groupsOfPairs), {{32, 5}});
    }
    runIndirect(recording, "rivals/examples/light_grid_allocate.comp", header_, offsetof(GnoLightGridHeader, groupsOfLists));
    recording.endPass();
}

void LightGridLists::recordItems(Recording& recording) const {
    recording.beginPass("light_grid_setup_items");
    runIndirect(recording, "rivals/examples/light_grid_pairs.comp", header_, offsetof(GnoLightGridHeader, groupsOfPairs), {{32, 7}});
    recording.endPass();
    recording.beginPass("light_grid_setup_sort");
    runIndirect(recording, "rivals/examples/light_grid_sort.comp", header_, offsetof(GnoLightGridHeader, groupsOfLists));
    recording.endPass();
}

NamedNumbers LightGridLists::bytes() const {
    return {{"lists", lists_.bytes()},
            {"items", itemPool_.bytes()},
            {"planes", planes_.bytes()},
            {"cells", assignment_.cellBytes() + depths_.bytes() + header_.bytes()},
            {"pairs", assignment_.pool().bytes()},
            {"casters", assignment_.casterBytes()}};
}

std::vector<DumpedBuffer> LightGridLists::dump() const {
    return {dumped("grid", "GnoForestGrid", assignment_.grid(), sizeof(GnoForestGrid), 1),
            dumped("lists", "GnoLightGridList list[]", lists_, sizeof(GnoLightGridList), gnoLightGridLists(assignment_.cellCount(), nests_)),
            dumped("items", "GnoLightGridItem item[]", itemPool_, sizeof(GnoLightGridItem), items_),
            dumped("light_grid_header", "GnoLightGridHeader", header_, sizeof(GnoLightGridHeader), 1)};
}

}  // namespace gno::host
