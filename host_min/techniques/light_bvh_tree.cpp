// SPDX-License-Identifier: MIT
#include "host_min/techniques/light_bvh_tree.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "glsl/core/radix_sort.h"
#include "host_min/error.hpp"
#include "host_min/techniques/cell_assignment.hpp"
#include "host_min/techniques/dumped.hpp"
#include "host_min/techniques/measure.hpp"

namespace gno::host {
namespace {

uint32_t groupsOf(uint32_t count) { return std::max(1u, gnoLightBvhGroups(count)); }

/// References whose nodes fit one binding, and whose passes fit one row of work groups.
uint32_t mostReferences(const DeviceFacts& device) {
    return uint32_t(std::min<uint64_t>(device.maxStorageBufferRange / 64, uint64_t(kMostGroups) * GNO_LIGHT_BVH_GROUP));
}

}  // namespace

LightBvhTree::LightBvhTree(const FrameInputs& inputs, const LightBvhOptions& options)
    : inputs_(inputs),
      grid_(inputs.device(), sizeof(GnoForestGrid), vk::BufferUsageFlagBits::eUniformBuffer),
      header_(inputs.device(), sizeof(GnoLightBvhHeader), vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eIndirectBuffer),
      masks_(inputs.device(), 4 * uint64_t(inputs.triangleCount())),
      sums_(inputs.device(), 4 * uint64_t(gnoLightBvhGroups(inputs.triangleCount()))),
      levels_(inputs.device(), GNO_LIGHT_BVH_LEVELS * sizeof(GnoLightBvhLevel),
              vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eIndirectBuffer),
      referenceList_(inputs.device(), 0),
      keys_(inputs.device(), 0),
      order_(inputs.device(), 0),
      otherKeys_(inputs.device(), 0),
      otherOrder_(inputs.device(), 0),
      counts_(inputs.device(), 0),
      boxes_(inputs.device(), 0),
      splits_(inputs.device(), 0),
      nodes_(inputs.device(), 0),
      parents_(inputs.device(), 0) {
    if (groupsOf(inputs.triangleCount()) > kMostGroups)
        throw InputError(
            fmt::format("{} triangles are over the light-space hierarchy's limit of {}", inputs.triangleCount(), kMostGroups * GNO_LIGHT_BVH_GROUP));
    const GnoForestGrid grid = forestGrid(inputs.light(), inputs.frame().low, inputs.frame().high, GNO_LIGHT_BVH_RESOLUTION);
    grid_.upload(std::span(&grid, 1));
    {
        Recording recording(inputs.device());
        recordCount(recording);
        recording.submit();
    }
    references_ = header_.downloadAs<GnoLightBvhHeader>().front().references;
    const uint32_t most = mostReferences(inputs.device().facts());
    if (references_ > most) throw InputError(fmt::format("the light-space hierarchy needs {} references, over the limit of {}", references_, most));
    if (options.pool > 0 && options.pool < references_)
        throw InputError(
            fmt::format("--set pool={}: the light-space hierarchy needs {} references: use a larger pool, or 0", options.pool, references_));
    const uint32_t capacity = options.pool > 0 ? options.pool : references_;
    const auto array = [&](uint64_t count, uint64_t bytes) { return Buffer(inputs.device(), count * bytes); };
    referenceList_ = array(capacity, sizeof(GnoLightBvhBox));
    for (Buffer* words : {&keys_, &order_, &otherKeys_, &otherOrder_}) *words = array(capacity, 4);
    counts_ = array(gnoSortCounts(capacity), 4);
    boxes_ = array(gnoLightBvhBoxes(capacity), sizeof(GnoLightBvhBox));
    splits_ = array(capacity, sizeof(GnoLightBvhBox));
    nodes_ = array(gnoLightBvhNodes(capacity), sizeof(GnoLightBvhNode));
    parents_ = array(gnoLightBvhNodes(capacity), 4);

    passes_.push_back({inputs.casterSetUp().name, inputs.casterSetUp().ms});
    for (const PassTime& time : measure(inputs.device(), options.repeat, options.warmUp, [&](Recording& recording) {
             recordCount(recording);
             recordTree(recording);
         }))
        passes_.push_back({time.name, time.ms});
    for (const GnoLightBvhLevel& level : levels_.downloadAs<GnoLightBvhLevel>()) {
        nodeCount_ += level.count;
        levelCount_ += level.count > 0;
    }
}

std::vector<Binding> LightBvhTree::resources() const {
    return {{"gnoLightBvhGrid", &grid_}, {"gnoLightBvhHeader", &header_}, {"gnoLightBvhNode", &nodes_}, {"gnoLightBvhParents", &parents_}};
}

std::vector<Binding> LightBvhTree::buildResources() const {
    std::vector<Binding> all = resources();
    all.insert(all.end(), {{"gnoCasters", &inputs_.casters()},
                           {"gnoStates", &inputs_.states()},
                           {"gnoLightBvhMasks", &masks_},
                           {"gnoLightBvhSums", &sums_},
                           {"gnoLightBvhLevels", &levels_},
                           {"gnoLightBvhReferences", &referenceList_},
                           {"gnoLightBvhKeys", &keys_},
                           {"gnoLightBvhOrder", &order_},
                           {"gnoLightBvhBoxes_", &boxes_},
                           {"gnoLightBvhSplits", &splits_}});
    return all;
}

const ComputePass& LightBvhTree::pass(const std::string& name) const {
    return inputs_.passes().compute("rivals/examples/light_bvh_" + name + ".comp");
}

void LightBvhTree::recordCount(Recording& recording) const {
    const ExamplePush push = inputs_.push();
    const auto bytes = std::as_bytes(std::span(&push, 1));
    const auto all = buildResources();
    recording.beginPass("light_bvh_setup_count");
    pass("count").dispatch(recording, all, bytes, groupsOf(inputs_.triangleCount()));
    recording.barrier();
    pass("begin").dispatch(recording, all, bytes, 1);
    recording.endPass();
}

void LightBvhTree::recordSort(Recording& recording) const {
    for (uint32_t round = 0; round < GNO_SORT_ROUNDS; ++round) {
        const bool odd = round % 2;
        const std::vector<Binding> all{{"gnoLightBvhHeader", &header_},
                                       {"gnoSortCountWords", &counts_},
                                       {"gnoLightBvhKeys", odd ? &otherKeys_ : &keys_},
                                       {"gnoLightBvhOrder", odd ? &otherOrder_ : &order_},
                                       {"gnoSortedKeys", odd ? &keys_ : &otherKeys_},
                                       {"gnoSortedOrder", odd ? &order_ : &otherOrder_}};
        const uint32_t shift = 4 * round;
        const auto bytes = std::as_bytes(std::span(&shift, 1));
        recording.barrier();
        pass("sort_count").dispatchIndirect(recording, all, bytes, header_, offsetof(GnoLightBvhHeader, groupsOfTiles));
        recording.barrier();
        pass("sort_prefix").dispatch(recording, all, bytes, 1);
        recording.barrier();
        pass("sort_scatter").dispatchIndirect(recording, all, bytes, header_, offsetof(GnoLightBvhHeader, groupsOfTiles));
    }
}

void LightBvhTree::recordTree(Recording& recording) const {
    ExamplePush push = inputs_.push();
    const auto bytes = std::as_bytes(std::span(&push, 1));
    const auto all = buildResources();
    recording.beginPass("light_bvh_setup_emit");
    pass("emit").dispatch(recording, all, bytes, groupsOf(inputs_.triangleCount()));
    recording.endPass();
    recording.beginPass("light_bvh_setup_sort");
    recordSort(recording);
    recording.endPass();
    recording.beginPass("light_bvh_build");
    pass("leaves").dispatchIndirect(recording, all, bytes, header_, 0);
    const auto capacity = uint32_t(referenceList_.bytes() / sizeof(GnoLightBvhBox));
    push.seed = 1;
    for (uint32_t boxes = capacity; boxes > 1; ++push.seed) {
        boxes = gnoLightBvhNextRow(boxes);
        recording.barrier();
        pass("up").dispatch(recording, all, bytes, groupsOf(boxes));
    }
    recording.barrier();
    pass("split").dispatchIndirect(recording, all, bytes, header_, 0);
    recording.endPass();
    recording.beginPass("light_bvh_build_collapse");
    for (push.seed = 0; push.seed < GNO_LIGHT_BVH_LEVELS; ++push.seed) {
        recording.barrier();
        pass("collapse").dispatchIndirect(recording, all, bytes, levels_, push.seed * sizeof(GnoLightBvhLevel));
    }
    recording.endPass();
}

NamedNumbers LightBvhTree::bytes() const {
    return {{"nodes", nodes_.bytes() + parents_.bytes()},
            {"grid", grid_.bytes() + header_.bytes()},
            {"build", masks_.bytes() + sums_.bytes() + levels_.bytes() + referenceList_.bytes() + keys_.bytes() + order_.bytes() +
                          otherKeys_.bytes() + otherOrder_.bytes() + counts_.bytes() + boxes_.bytes() + splits_.bytes()}};
}

std::vector<DumpedBuffer> LightBvhTree::dump() const {
    return {dumped("grid", "GnoForestGrid", grid_, sizeof(GnoForestGrid), 1),
            dumped("light_bvh_header", "GnoLightBvhHeader", header_, sizeof(GnoLightBvhHeader), 1),
            dumped("levels", "GnoLightBvhLevel level[]", levels_, sizeof(GnoLightBvhLevel), GNO_LIGHT_BVH_LEVELS),
            dumped("nodes", "GnoLightBvhNode node[]", nodes_, sizeof(GnoLightBvhNode), nodeCount_),
            dumped("parents", "uint parent[]", parents_, 4, nodeCount_)};
}

}  // namespace gno::host
