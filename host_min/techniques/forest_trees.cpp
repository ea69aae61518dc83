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

constexpr std::array kResolutions{4u, 8u, 16u, 32u, 64u, 128u, 256u};

/// What a build and a query cost together, in visited nodes of a query: a pair costs as much as 65, a sample visits 5.5 times the 0.3rd power of the pairs that a cell
/// holds in the mean. Fitted to 13 scenes at 1920x1080, see glsl/README.md, "How many cells".
double expectedVisits(const GnoForestHeader& found, uint64_t samples) {
    return 65.0 * found.pairs + double(samples) * 5.5 * std::pow(double(found.pairs) / std::max(1u, found.used), 0.3);
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
      grid_(inputs.device(), sizeof(GnoForestGrid), vk::BufferUsageFlagBits::eUniformBuffer),
      cells_(inputs.device(), sizeof(GnoForestCell)),
      header_(inputs.device(), sizeof(GnoForestHeader), vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eIndirectBuffer),
      list_(inputs.device(), 4 * uint64_t(inputs.triangleCount())),
      few_(inputs.device(), sizeof(GnoForestFew) * uint64_t(inputs.triangleCount())),
      pool_(inputs.device(), 8),
      planes_(inputs.device(), 64),
      links_(inputs.device(), 64),
      slabs_(inputs.device(), 64) {
    if (groupsOf(inputs.triangleCount()) > kMostGroups)
        throw InputError(fmt::format("{} triangles are over the forest's limit of {}", inputs.triangleCount(), kMostGroups * GNO_FOREST_GROUP));
    if (options.resolution == 0) chooseResolution();
    else count(options.resolution);
    const uint32_t most = mostPairs(inputs.device().facts());
    if (found_.pairs > most)
        throw InputError(fmt::format("the forest needs {} pairs of cell and caster, over the limit of {}: use a smaller --set cells than {}", found_.pairs, most,
                                     resolution_));
    if (options.pool > 0 && options.pool < found_.pairs)
        throw InputError(fmt::format("--set pool={}: the forest needs {} pairs of cell and caster: use a larger pool, or 0", options.pool, found_.pairs));
    const uint64_t capacity = options.pool > 0 ? options.pool : found_.pairs;
    pool_ = Buffer(inputs.device(), std::max<uint64_t>(capacity, 1) * sizeof(GnoForestPair));
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

void ForestTrees::count(uint32_t resolution) {
    resolution_ = resolution;
    const GnoForestGrid grid = forestGrid(inputs_.light(), inputs_.frame().low, inputs_.frame().high, resolution);
    grid_.upload(std::span(&grid, 1));
    cells_ = Buffer(inputs_.device(), uint64_t(gnoCellCount(grid.resolution, grid.faces)) * sizeof(GnoForestCell));
    cellCount_ = gnoCellCount(grid.resolution, grid.faces);
    Recording recording(inputs_.device());
    recordAssignment(recording);
    recording.submit();
    found_ = header_.downloadAs<GnoForestHeader>().front();
}

void ForestTrees::chooseResolution() {
    double least = std::numeric_limits<double>::max();
    uint32_t best = kResolutions.front();
    for (const uint32_t resolution : kResolutions) {
        count(resolution);
        const double cost = expectedVisits(found_, inputs_.sampleCount());
        if (cost < least) {
            least = cost;
            best = resolution;
        } else if (cost > 1.3 * least) {
            break;
        }
    }
    if (resolution_ != best) count(best);
}

std::vector<Binding> ForestTrees::resources() const {
    return {{"gnoCasters", &inputs_.casters()}, {"gnoStates", &inputs_.states()}, {"gnoSamples", &inputs_.samples()}, {"gnoForestGrid", &grid_},
            {"gnoForestCells", &cells_},        {"gnoForestPairs", &pool_},       {"gnoForestHeader", &header_},      {"gnoForestFew", &few_},         {"gnoList", &list_},
            {"gnoTopPlanes", &planes_},         {"gnoTopLinks", &links_},         {"gnoTopHeader", &header_},         {"gnoTopSlabs", &slabs_}};
}

const ComputePass& ForestTrees::pass(const std::string& name, Specialization constants) const {
    if (name.starts_with("assign") || name == "sort.comp") {
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
    const bool emit = which == 6;
    recording.barrier();
    pass("assign_many.comp", {{32, which}}).dispatchIndirect(recording, all, bytes, header_, offsetof(GnoForestHeader, groupsOfMany));
    if (emit) recording.barrier();  // the larger ones first
    pass("assign_some.comp", {{32, which}}).dispatchIndirect(recording, all, bytes, header_, offsetof(GnoForestHeader, groupsOfSome));
    if (which == 3) return;
    if (emit) recording.barrier();
    pass("assign_few.comp", {{32, which}}).dispatch(recording, all, bytes, groupsOf(inputs_.triangleCount()));
}

void ForestTrees::recordAssignment(Recording& recording) const {
    const ExamplePush push = inputs_.push(options_.seed);
    const auto bytes = std::as_bytes(std::span(&push, 1));
    const auto all = resources();
    recording.beginPass("forest_setup_depth");
    pass("reset.comp").dispatch(recording, all, bytes, groupsOf(cellCount_));
    recording.barrier();
    if (options_.viewCull) pass("depth.comp").dispatch(recording, all, bytes, (inputs_.width() + 31) / 32, (inputs_.height() + 15) / 16);
    recording.endPass();
    recording.beginPass("forest_setup_sort");
    pass("sort.comp").dispatch(recording, all, bytes, groupsOf(inputs_.triangleCount()));
    recording.barrier();
    pass("sizes.comp").dispatch(recording, all, bytes, 1);
    recording.endPass();
    recording.beginPass("forest_setup_count");
    if (options_.cover) step(recording, 3);
    step(recording, 4);
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
    step(recording, 6);
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
            {"casters", list_.bytes() + few_.bytes()}};
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
