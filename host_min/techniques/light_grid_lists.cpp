// SPDX-License-Identifier: MIT
#include "host_min/techniques/light_grid_lists.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_min/error.hpp"
#include "host_min/techniques/dumped.hpp"

namespace gno::host {
namespace {

/// `what` is in the pool of `given` entries (0: of any size).
void checkPool(const char* what, uint32_t needed, uint32_t given, uint64_t most, uint32_t resolution) {
    if (needed > most)
        throw LimitError(
            fmt::format("the light grid needs {} {}, over the limit of {}: use a smaller --set cells than {}", needed, what, most, resolution));
    if (given > 0 && given < needed)
        throw InputError(fmt::format("--set pool={}: the light grid needs {} {}: use a larger pool, or 0", given, needed, what));
}

}  // namespace

void LightGridLists::prepare(const FrameInputs& inputs) {
    inputs_ = &inputs;
    const uint64_t range = inputs.device().facts().maxStorageBufferRange;
    cells_ = lightCells(inputs, settings_.resolution, settings_.viewCull, settings_.cover);
    const auto enlarge = [&](uint64_t& pool, uint64_t first, uint64_t learned) {
        const uint64_t wanted = settings_.pool > 0 ? forestPool(settings_.pool) : std::min(learned > 0 ? forestPoolFor(learned) : first, most());
        pool = std::max(pool, wanted);
    };
    const LightGridPools first = lightGridFirstPools(inputs.casterCount());
    enlarge(pools_.pairs, first.pairs, pairs_);
    enlarge(pools_.items, first.items, items_);
    const uint64_t nests = lightGridNests(cells_, pools_.pairs, settings_.options.nest, range);
    arrays_.fit(inputs.device(), lightGridArrays(cells_, pools_, nests, settings_.options));
    writeGrid(arrays_["gnoForestGrid"], inputs, cells_);
    passes_ = PassRunner(inputs.passes(), lightGridBuildPasses(cells_, settings_.options), inputs.withCasters(arrays_.bindings()));
}

void LightGridLists::record(Recording& recording, uint32_t) const { passes_.record(recording, inputs_->push()); }

bool LightGridLists::read() {
    const auto header = arrays_["gnoGridHeader"].downloadAs<GnoLightGridHeader>().front();
    const auto room = uint32_t(arrays_["gnoGridDepths"].bytes() / (4 * GNO_LIGHT_GRID_GROUP));
    pairs_ = arrays_["gnoForestHeader"].downloadAs<GnoForestHeader>().front().pairs;
    nests_ = std::min(header.nests, room);
    crowded_ = header.nests - nests_;
    checkPool("pairs of cell and caster", pairs_, settings_.pool, most(), settings_.resolution);
    const bool whole = pairs_ <= pools_.pairs;
    items_ = header.items;  // of what the pool of pairs had room for
    checkPool("items of lists", items_, settings_.pool, most(), settings_.resolution);
    return whole && items_ <= pools_.items;
}

NamedNumbers LightGridLists::bytes() const {
    return {{"lists", arrays_.bytes({"gnoGridLists"})},
            {"items", arrays_.bytes({"gnoGridItems"})},
            {"planes", settings_.options.planes ? arrays_.bytes({"gnoGridPlanes"}) : 0},
            {"cells", arrays_.bytes({"gnoForestCells", "gnoForestGrid", "gnoForestHeader", "gnoGridDepths", "gnoGridHeader"})},
            {"pairs", arrays_.bytes({"gnoForestPairs"})},
            {"casters", arrays_.bytes({"gnoList", "gnoForestFew"})}};
}

std::vector<DumpedBuffer> LightGridLists::dump() const {
    return {dumped("grid", "GnoForestGrid", arrays_["gnoForestGrid"], sizeof(GnoForestGrid), 1),
            dumped("lists", "GnoLightGridList list[]", arrays_["gnoGridLists"], sizeof(GnoLightGridList), gnoLightGridLists(cells_.count(), nests_)),
            dumped("items", "GnoLightGridItem item[]", arrays_["gnoGridItems"], sizeof(GnoLightGridItem), items_),
            dumped("light_grid_header", "GnoLightGridHeader", arrays_["gnoGridHeader"], sizeof(GnoLightGridHeader), 1)};
}

}  // namespace gno::host
