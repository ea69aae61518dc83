// SPDX-License-Identifier: MIT
#include "host_min/techniques/forest_trees.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_min/error.hpp"
#include "host_min/techniques/build_totals.hpp"
#include "host_min/techniques/dumped.hpp"

namespace gno::host {
namespace {

constexpr std::array<std::string_view, kForestResolutions.size()> kCountParts{
    "forest_setup_choose_4",  "forest_setup_choose_8",   "forest_setup_choose_16", "forest_setup_choose_32",
    "forest_setup_choose_64", "forest_setup_choose_128", "forest_setup_choose_256"};

}  // namespace

void ForestTrees::prepare(const FrameInputs& inputs) {
    inputs_ = &inputs;
    if (settings_.choice == CellChoice::counted) {
        prepareCandidates();
        return;
    }
    segments_ = 1;
    const uint32_t resolution =
        settings_.choice == CellChoice::given ? settings_.resolution : forestResolution(inputs.casterCount(), inputs.sampleCount());
    prepareBuild(resolution, poolBefore());
}

/// Pairs to make room for before anything of the frame is known.
uint64_t ForestTrees::poolBefore() const {
    if (settings_.pool > 0) return forestPool(settings_.pool);
    return std::min(learned_ > 0 ? forestPoolFor(learned_) : forestFirstPool(inputs_->casterCount()), mostPairs());
}

void ForestTrees::prepareBuild(uint32_t resolution, uint64_t pool) {
    cells_ = lightCells(*inputs_, resolution, settings_.viewCull, settings_.cover);
    arrays_.fit(inputs_->device(), forestArrays(cells_, pool, settings_.options));
    writeGrid(arrays_["gnoForestGrid"], *inputs_, cells_);
    passes_ = PassRunner(inputs_->passes(), forestBuildPasses(cells_, settings_.options), inputs_->withCasters(arrays_.bindings()));
}

void ForestTrees::prepareCandidates() {
    const Device& device = inputs_->device();
    candidates_.clear();
    cells_ = lightCells(*inputs_, kForestResolutions.back(), settings_.viewCull, settings_.cover);
    candidateCells_.emplace(device, arrayNamed(lightCellArrays(cells_, 2), "gnoForestCells").bytes);
    candidatePairs_.emplace(device, 2 * sizeof(GnoForestPair));  // bound, and nothing is put there
    cells_.resolution = kForestResolutions.front();
    arrays_.fit(device, forestArrays(cells_, forestPool(0), settings_.options));
    for (size_t i = 0; i < kForestResolutions.size(); ++i) {
        cells_.resolution = kForestResolutions[i];
        candidates_.push_back({cells_.resolution, Buffer(device, sizeof(GnoForestGrid), vk::BufferUsageFlagBits::eUniformBuffer), {}});
        Candidate& candidate = candidates_.back();
        writeGrid(candidate.grid, *inputs_, cells_);
        PassList list = forestCountPasses(cells_);
        for (Pass& pass : list) pass.part = kCountParts[i];
        std::vector<Binding> resources{
            {"gnoForestGrid", &candidate.grid}, {"gnoForestCells", &*candidateCells_}, {"gnoForestPairs", &*candidatePairs_}};
        for (const Binding& binding : inputs_->withCasters(arrays_.bindings())) resources.push_back(binding);
        candidate.passes = PassRunner(inputs_->passes(), list, resources);
    }
    segments_ = uint32_t(candidates_.size()) + 1;
}

void ForestTrees::record(Recording& recording, uint32_t segment) const {
    const PassRunner& passes = segment + 1 < segments_ ? candidates_[segment].passes : passes_;
    passes.record(recording, inputs_->push(settings_.options.seed));
}

/// More cells until the cost is clearly over the least, then the build with the best.
void ForestTrees::between(uint32_t segment) {
    if (segment == 0) {
        costs_.clear();
        counted_.clear();
        segments_ = uint32_t(candidates_.size()) + 1;
    }
    const GnoForestHeader counted = header();
    cells_.resolution = candidates_[segment].resolution;
    costs_.push_back(forestVisits(counted.pairs, counted.used, inputs_->sampleCount(), cells_.count()));
    counted_.push_back(counted.pairs);
    const auto least = std::min_element(costs_.begin(), costs_.end());
    if (costs_.back() <= 1.3 * *least && costs_.size() < candidates_.size()) return;
    segments_ = segment + 2;
    const auto best = size_t(least - costs_.begin());
    prepareBuild(candidates_[best].resolution,
                 settings_.pool > 0 ? forestPool(settings_.pool) : forestPool(std::min<uint64_t>(counted_[best], mostPairs())));
}

void ForestTrees::count() {
    const BuildTotals totals(inputs_->device());
    std::vector<Binding> resources = inputs_->withCasters(arrays_.bindings());
    resources.push_back(totals.binding());
    const PassRunner counting(inputs_->passes(), passes_.list(), resources, {.counters = true});
    Recording recording(inputs_->device());
    counting.record(recording, inputs_->push(settings_.options.seed));
    recording.submit();
    counters_ = totals.read();
}

bool ForestTrees::read() {
    found_ = header();
    if (found_.pairs > mostPairs())
        throw LimitError(fmt::format("the forest needs {} pairs of cell and caster, over the limit of {}: use a smaller --set cells than {}",
                                     found_.pairs, mostPairs(), resolution()));
    if (settings_.pool > 0 && settings_.pool < found_.pairs)
        throw InputError(
            fmt::format("--set pool={}: the forest needs {} pairs of cell and caster: use a larger pool, or 0", settings_.pool, found_.pairs));
    learned_ = found_.pairs;
    return found_.pairs <= arrays_["gnoForestPairs"].bytes() / sizeof(GnoForestPair);
}

NamedNumbers ForestTrees::bytes() const {
    NamedNumbers all{{"trees", (settings_.options.storePlanes ? arrays_["gnoTopPlanes"].bytes() : 0) + arrays_["gnoTopLinks"].bytes() +
                                   (settings_.options.slab ? arrays_["gnoTopSlabs"].bytes() : 0)},
                     {"cells", arrays_.bytes({"gnoForestCells", "gnoForestGrid", "gnoForestHeader", "gnoTopHeader"})},
                     {"pairs", arrays_.bytes({"gnoForestPairs"})},
                     {"casters", arrays_.bytes({"gnoList", "gnoForestFew"})}};
    if (candidateCells_)
        all.emplace_back("counting", candidateCells_->bytes() + candidatePairs_->bytes() + candidates_.size() * candidates_.front().grid.bytes());
    return all;
}

std::vector<DumpedBuffer> ForestTrees::dump() const {
    const uint64_t pairs = found_.pairs;
    std::vector<DumpedBuffer> all{dumped("grid", "GnoForestGrid", arrays_["gnoForestGrid"], sizeof(GnoForestGrid), 1),
                                  dumped("cells", "GnoForestCell cell[]", arrays_["gnoForestCells"], sizeof(GnoForestCell), cells_.count()),
                                  dumped("pairs", "GnoForestPair pair[]", arrays_["gnoForestPairs"], sizeof(GnoForestPair), pairs),
                                  dumped("forest_header", "GnoForestHeader", arrays_["gnoForestHeader"], sizeof(GnoForestHeader), 1),
                                  dumped("links", "GnoTopLink link[4 * pairs]", arrays_["gnoTopLinks"], sizeof(GnoTopLink), 4 * pairs)};
    if (settings_.options.storePlanes) all.push_back(dumped("planes", "vec4 plane[4 * pairs]", arrays_["gnoTopPlanes"], 16, 4 * pairs));
    return all;
}

}  // namespace gno::host
