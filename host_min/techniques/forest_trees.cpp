// SPDX-License-Identifier: MIT
#include "host_min/techniques/forest_trees.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "host_min/error.hpp"
#include "host_min/techniques/measure.hpp"

namespace gno::host {
namespace {

constexpr uint32_t kMostGroups = 65535;  // the least maxComputeWorkGroupCount that Vulkan allows

uint32_t groupsOf(uint32_t count) { return std::max(1u, (count + GNO_FOREST_GROUP - 1) / GNO_FOREST_GROUP); }

/// Pairs whose planes fit one binding, and whose passes fit one row of work groups.
uint32_t mostPairs(const DeviceFacts& device) {
    return uint32_t(std::min<uint64_t>(device.maxStorageBufferRange / 64, uint64_t(kMostGroups) * GNO_FOREST_GROUP));
}

}  // namespace

GnoForestGrid forestGrid(glm::vec4 light, glm::vec3 low, glm::vec3 high, uint32_t resolution) {
    GnoForestGrid grid{};
    grid.resolution = resolution;
    if (light.w != 0) {
        grid.faces = 6;
        grid.across.w = grid.along.w = -1;
        grid.stepAcross = grid.stepAlong = 2.0f / float(resolution);
        return grid;
    }
    grid.faces = 1;
    const glm::dvec3 towards = glm::normalize(glm::dvec3(light));
    const glm::dvec3 other = std::abs(towards.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 across = glm::normalize(glm::cross(towards, other)), along = glm::cross(towards, across);
    const auto place = [&](const glm::dvec3& axis, glm::vec4& stored, float& step) {
        double least = std::numeric_limits<double>::max(), greatest = -least;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 p((corner & 1) ? high.x : low.x, (corner & 2) ? high.y : low.y, (corner & 4) ? high.z : low.z);
            least = std::min(least, glm::dot(axis, p));
            greatest = std::max(greatest, glm::dot(axis, p));
        }
        stored = glm::vec4(glm::vec3(axis), float(least));
        step = float(std::max(greatest - least, 1e-6) / resolution);
    };
    place(across, grid.across, grid.stepAcross);
    place(along, grid.along, grid.stepAlong);
    return grid;
}

ForestTrees::ForestTrees(const FrameInputs& inputs, const ForestOptions& options)
    : inputs_(inputs),
      options_(options),
      cellCount_(gnoCellCount(options.resolution, inputs.light().w != 0 ? 6 : 1)),
      grid_(inputs.device(), sizeof(GnoForestGrid), vk::BufferUsageFlagBits::eUniformBuffer),
      cells_(inputs.device(), uint64_t(cellCount_) * sizeof(GnoForestCell)),
      header_(inputs.device(), sizeof(GnoForestHeader), vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eIndirectBuffer),
      largeList_(inputs.device(), 4 * uint64_t(inputs.triangleCount())),
      pool_(inputs.device(), 8),
      planes_(inputs.device(), 64),
      links_(inputs.device(), 64),
      slabs_(inputs.device(), 64) {
    if (groupsOf(inputs.triangleCount()) > kMostGroups)
        throw InputError(fmt::format("{} triangles are over the forest's limit of {}", inputs.triangleCount(), kMostGroups * GNO_FOREST_GROUP));
    const GnoForestGrid grid = forestGrid(inputs.light(), inputs.frame().low, inputs.frame().high, options.resolution);
    grid_.upload(std::span(&grid, 1));
    {
        Recording recording(inputs.device());
        recordAssignment(recording);
        recording.submit();
    }
    const auto header = header_.downloadAs<GnoForestHeader>().front();
    pairs_ = header.pairs;
    large_ = header.large;
    const uint32_t most = mostPairs(inputs.device().facts());
    if (pairs_ > most)
        throw InputError(fmt::format("the forest needs {} pairs of cell and caster, over the limit of {}: use a smaller --set cells than {}", pairs_, most,
                                     options.resolution));
    if (options.pool > 0 && options.pool < pairs_)
        throw InputError(fmt::format("--set pool={}: the forest needs {} pairs of cell and caster: use a larger pool, or 0", options.pool, pairs_));
    const uint64_t capacity = options.pool > 0 ? options.pool : pairs_;
    pool_ = Buffer(inputs.device(), capacity * sizeof(GnoForestPair));
    planes_ = Buffer(inputs.device(), topPlaneBytes(capacity));
    links_ = Buffer(inputs.device(), topLinkBytes(capacity));
    if (options.slab) slabs_ = Buffer(inputs.device(), topSlabBytes(capacity));
    if (options.counters) {
        Buffer totals(inputs.device(), 5 * 4);
        totals.fill(0);
        Recording recording(inputs.device());
        recordAssignment(recording);
        recordTrees(recording, &totals);
        recording.submit();
        const auto words = totals.downloadAs<uint32_t>();
        counters_ = {uint64_t(words[1]) << 32 | words[0], words[2], words[3], words[4]};
    }
    passes_.push_back({inputs.casterSetUp().name, inputs.casterSetUp().ms});
    for (const PassTime& time : measure(inputs.device(), options.repeat, options.warmUp, [&](Recording& recording) {
             recordAssignment(recording);
             recordTrees(recording, nullptr);
         }))
        passes_.push_back({time.name, time.ms});
}

std::vector<Binding> ForestTrees::resources() const {
    return {{"gnoCasters", &inputs_.casters()}, {"gnoStates", &inputs_.states()}, {"gnoSamples", &inputs_.samples()}, {"gnoForestGrid", &grid_},
            {"gnoForestCells", &cells_},        {"gnoForestPairs", &pool_},       {"gnoForestHeader", &header_},      {"gnoLarge", &largeList_},
            {"gnoTopPlanes", &planes_},         {"gnoTopLinks", &links_},         {"gnoTopHeader", &header_}, {"gnoTopSlabs", &slabs_}};
}

const ComputePass& ForestTrees::pass(const std::string& name, Specialization constants) const {
    if (name.starts_with("assign")) {
        constants[30] = options_.viewCull;
        constants[31] = options_.cover;
    }
    if (name.starts_with("set_up") || name.starts_with("build")) {
        constants[0] = uint32_t(options_.precision);
        constants[3] = options_.slab;
    }
    return inputs_.passes().compute("forest/examples/" + name, constants);
}

void ForestTrees::step(Recording& recording, uint32_t which) const {
    const ExamplePush push = inputs_.push(options_.seed);
    const auto bytes = std::as_bytes(std::span(&push, 1));
    const auto all = resources();
    recording.barrier();
    pass("assign.comp", {{32, which}}).dispatch(recording, all, bytes, groupsOf(inputs_.triangleCount()));
    recording.barrier();
    if (which == 2) {
        pass("sizes.comp").dispatch(recording, all, bytes, 1);
        recording.barrier();
    }
    pass("assign_large.comp", {{32, which}}).dispatchIndirect(recording, all, bytes, header_, offsetof(GnoForestHeader, groupsOfLarge));
}

void ForestTrees::recordAssignment(Recording& recording) const {
    const ExamplePush push = inputs_.push(options_.seed);
    const auto bytes = std::as_bytes(std::span(&push, 1));
    const auto all = resources();
    recording.beginPass("forest_setup_depth");
    pass("reset.comp").dispatch(recording, all, bytes, groupsOf(cellCount_));
    recording.barrier();
    if (options_.viewCull) pass("depth.comp").dispatch(recording, all, bytes, (inputs_.width() + 7) / 8, (inputs_.height() + 7) / 8);
    recording.endPass();
    recording.beginPass("forest_setup_count");
    step(recording, 2);
    step(recording, 3);
    recording.barrier();
    pass("allocate.comp").dispatch(recording, all, bytes, groupsOf(cellCount_));
    recording.barrier();
    pass("sizes.comp").dispatch(recording, all, bytes, 1);
    recording.endPass();
}

void ForestTrees::recordTrees(Recording& recording, const Buffer* totals) const {
    const ExamplePush push = inputs_.push(options_.seed);
    const auto bytes = std::as_bytes(std::span(&push, 1));
    auto all = resources();
    if (totals) all.push_back({"gnoTotals", totals});
    recording.beginPass("forest_setup_emit");
    step(recording, 5);
    recording.endPass();
    recording.beginPass("forest_setup");
    pass("set_up.comp").dispatchIndirect(recording, all, bytes, header_, offsetof(GnoForestHeader, groupsOfPairs));
    recording.endPass();
    recording.beginPass("forest_build");
    pass(totals ? "build.comp.counters" : "build.comp").dispatchIndirect(recording, all, bytes, header_, offsetof(GnoForestHeader, groupsOfPairs));
    recording.endPass();
}

NamedNumbers ForestTrees::bytes() const {
    return {{"trees", planes_.bytes() + links_.bytes() + (options_.slab ? slabs_.bytes() : 0)}, {"cells", cells_.bytes() + grid_.bytes() + header_.bytes()}, {"pairs", pool_.bytes()},
            {"large_list", largeList_.bytes()}};
}

std::vector<DumpedBuffer> ForestTrees::dump() const {
    return {{"grid", "GnoForestGrid", grid_.download()},
            {"cells", "GnoForestCell cell[]", cells_.download()},
            {"pairs", "GnoForestPair pair[]", pool_.download()},
            {"forest_header", "GnoForestHeader", header_.download()},
            {"planes", "vec4 plane[4 * pairs]", planes_.download()},
            {"links", "GnoTopLink link[4 * pairs]", links_.download()}};
}

}  // namespace gno::host
