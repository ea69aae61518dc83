// SPDX-License-Identifier: MIT
#include "host_min/techniques/forest_trees.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "host_min/error.hpp"
#include "host_min/techniques/dumped.hpp"
#include "host_min/techniques/measure.hpp"

namespace gno::host {
namespace {

uint32_t groupsOf(uint32_t count) { return std::max(1u, (count + GNO_FOREST_GROUP - 1) / GNO_FOREST_GROUP); }

/// Pairs whose planes fit one binding, and whose passes fit one row of work groups.
uint32_t mostPairs(const DeviceFacts& device) {
    return uint32_t(std::min<uint64_t>(device.maxStorageBufferRange / 64, uint64_t(kMostGroups) * GNO_FOREST_GROUP));
}

constexpr std::array kResolutions{4u, 8u, 16u, 32u, 64u, 128u, 256u};

/// What a build and a query cost together, in visited nodes of a query: a pair costs as much as 65, a cell as 4, a sample visits 5.5 times the 0.3rd
/// power of the pairs that a cell holds in the mean. Fitted to 13 scenes at 1920x1080, see glsl/README.md, "How many cells".
double expectedVisits(const GnoForestHeader& found, uint64_t samples, uint32_t cells) {
    return 65.0 * found.pairs + 4.0 * cells + double(samples) * 5.5 * std::pow(double(found.pairs) / std::max(1u, found.used), 0.3);
}

}  // namespace

ForestTrees::ForestTrees(const FrameInputs& inputs, const ForestOptions& options)
    : inputs_(inputs),
      options_(options),
      assignment_(inputs, "forest", options.viewCull, options.cover, options.seed),
      planes_(inputs.device(), topPlaneBytes(0)),
      links_(inputs.device(), topLinkBytes(0)),
      slabs_(inputs.device(), topSlabBytes(0)) {
    if (options.resolution == 0)
        chooseResolution();
    else
        count(options.resolution);
    const uint32_t most = mostPairs(inputs.device().facts());
    if (found_.pairs > most)
        throw InputError(fmt::format("the forest needs {} pairs of cell and caster, over the limit of {}: use a smaller --set cells than {}",
                                     found_.pairs, most, resolution()));
    if (options.pool > 0 && options.pool < found_.pairs)
        throw InputError(
            fmt::format("--set pool={}: the forest needs {} pairs of cell and caster: use a larger pool, or 0", options.pool, found_.pairs));
    const uint64_t capacity = options.pool > 0 ? options.pool : found_.pairs;
    assignment_.setPool(capacity);
    if (options.storePlanes) planes_ = Buffer(inputs.device(), topPlaneBytes(capacity));
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
    assignment_.setResolution(resolution);
    Recording recording(inputs_.device());
    recordAssignment(recording);
    recording.submit();
    found_ = assignment_.header().downloadAs<GnoForestHeader>().front();
}

void ForestTrees::chooseResolution() {
    double least = std::numeric_limits<double>::max();
    uint32_t best = kResolutions.front();
    for (const uint32_t resolution : kResolutions) {
        count(resolution);
        const double cost = expectedVisits(found_, inputs_.sampleCount(), assignment_.cellCount());
        if (cost < least) {
            least = cost;
            best = resolution;
        } else if (cost > 1.3 * least) {
            break;
        }
    }
    if (resolution() != best) count(best);
}

std::vector<Binding> ForestTrees::resources() const {
    auto all = assignment_.resources();
    all.insert(all.end(), {{"gnoTopPlanes", &planes_}, {"gnoTopLinks", &links_}, {"gnoTopHeader", &assignment_.header()}, {"gnoTopSlabs", &slabs_}});
    return all;
}

void ForestTrees::recordAssignment(Recording& recording) const {
    const ExamplePush push = inputs_.push(options_.seed);
    const auto bytes = std::as_bytes(std::span(&push, 1));
    const auto pass = [&](const char* name) -> const ComputePass& { return inputs_.passes().compute(std::string("forest/examples/") + name); };
    recording.beginPass("forest_setup_depth");
    assignment_.recordDepth(recording);
    recording.endPass();
    recording.beginPass("forest_setup_sort");
    assignment_.recordSort(recording);
    recording.endPass();
    recording.beginPass("forest_setup_count");
    assignment_.recordCount(recording);
    recording.barrier();
    pass("allocate.comp").dispatch(recording, resources(), bytes, groupsOf(assignment_.cellCount()));
    recording.barrier();
    pass("sizes.comp").dispatch(recording, resources(), bytes, 1);
    recording.endPass();
}

void ForestTrees::recordTrees(Recording& recording, const Buffer* totals) const {
    const ExamplePush push = inputs_.push(options_.seed);
    const auto bytes = std::as_bytes(std::span(&push, 1));
    auto all = resources();
    if (totals) all.push_back({"gnoTotals", totals});
    const auto overPairs = [&](const char* name) {
        inputs_.passes()
            .compute(std::string("forest/examples/") + name, {{0, uint32_t(options_.precision)}, {3, options_.slab}, {4, options_.storePlanes}})
            .dispatchIndirect(recording, all, bytes, assignment_.header(), offsetof(GnoForestHeader, groupsOfPairs));
    };
    recording.beginPass("forest_setup_emit");
    assignment_.recordEmit(recording);
    recording.endPass();
    recording.beginPass("forest_setup");
    overPairs("set_up.comp");
    recording.endPass();
    recording.beginPass("forest_build");
    overPairs(totals ? "build.comp.counters" : "build.comp");
    recording.endPass();
}

NamedNumbers ForestTrees::bytes() const {
    return {{"trees", (options_.storePlanes ? planes_.bytes() : 0) + links_.bytes() + (options_.slab ? slabs_.bytes() : 0)},
            {"cells", assignment_.cellBytes()},
            {"pairs", assignment_.pool().bytes()},
            {"casters", assignment_.casterBytes()}};
}

std::vector<DumpedBuffer> ForestTrees::dump() const {
    const uint64_t pairs = found_.pairs;
    std::vector<DumpedBuffer> all{dumped("grid", "GnoForestGrid", assignment_.grid(), sizeof(GnoForestGrid), 1),
                                  dumped("cells", "GnoForestCell cell[]", assignment_.cells(), sizeof(GnoForestCell), assignment_.cellCount()),
                                  dumped("pairs", "GnoForestPair pair[]", assignment_.pool(), sizeof(GnoForestPair), pairs),
                                  dumped("forest_header", "GnoForestHeader", assignment_.header(), sizeof(GnoForestHeader), 1),
                                  dumped("links", "GnoTopLink link[4 * pairs]", links_, sizeof(GnoTopLink), 4 * pairs)};
    if (options_.storePlanes) all.push_back(dumped("planes", "vec4 plane[4 * pairs]", planes_, 16, 4 * pairs));
    return all;
}

}  // namespace gno::host
