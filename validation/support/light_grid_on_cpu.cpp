// SPDX-License-Identifier: MIT
// One variant: GNO_LIGHT_GRID_VARIANT is its name. A variant of other text finds it first on its include path (-iquote).
// Everything is in an unnamed namespace, so that one program can hold many.
#include "validation/support/light_grid_on_cpu.hpp"

#ifndef GNO_LIGHT_GRID_VARIANT
#error "define GNO_LIGHT_GRID_VARIANT, a name"
#endif

#define GNO_ON_CPU_TREES 0
#define GNO_ON_CPU_CELLS 1
#include "validation/support/trees_on_cpu.hpp"

namespace gno {
namespace {

struct ListState {
    Array<GnoLightGridList> lists;
    Array<uint> depths;
    Array<GnoLightGridItem> items;
    Array<vec4> planes;
    GnoLightGridHeader header{};
    uint nest = 8;
} ours;

#define GNO_LIGHT_GRID_LISTS ours.lists
#define GNO_LIGHT_GRID_DEPTHS ours.depths
#define GNO_LIGHT_GRID_NESTS uint(ours.depths.size() / GNO_LIGHT_GRID_GROUP)
#define GNO_LIGHT_GRID_ITEMS ours.items
#define GNO_LIGHT_GRID_CAPACITY uint(ours.items.size())
#define GNO_LIGHT_GRID_HEADER ours.header
#define GNO_LIGHT_GRID_STATE gnoLightGridState(ours.header, GNO_LIGHT_GRID_PLANES != 0)
#define GNO_LIGHT_GRID_NEST ours.nest
#define GNO_LIGHT_GRID_SHORT 0xFFFFFFFFu
#define GNO_LIGHT_GRID_LOAD_PLANE(index_) ours.planes[index_]

#define shared static
void barrier() {}
void memoryBarrierBuffer() {}

#include "glsl/rivals/light_grid_build.glsl"
#include "glsl/rivals/light_grid_sort.glsl"
#define GNO_LIGHT_GRID_PLANES 1
#include "glsl/rivals/light_grid_query.glsl"
#undef GNO_LIGHT_GRID_PLANES
#undef GNO_RIVALS_LIGHT_GRID_QUERY_GLSL
namespace computed {
#define GNO_LIGHT_GRID_PLANES 0
#include "glsl/rivals/light_grid_query.glsl"
}  // namespace computed

class Grid final : public cpu::LightGrid {
public:
    void build(std::span<const GnoCaster> casters, vec4 light, const GnoForestGrid& grid, std::span<const GnoViewSample> samples,
               uint nest) override {
        state.casters.assign(casters.begin(), casters.end());
        state.light = light;
        state.grid = grid;
        ours.nest = nest;
        openCells(samples);
        const uint count = uint(state.cells.size()), seed = 1;
        ours.lists.assign(gnoLightGridLists(count, count), GnoLightGridList{kPoison, kPoison});
        ours.depths.assign(64 * count, kPoison);
        ours.planes.assign(4 * casters.size(), vec4(0));
        const Lists byCells = sortCasters();
        assign(Assign::cover, byCells, seed);
        assign(Assign::count, byCells, seed);
        gnoLightGridReset();
        for (uint cell = 0; cell < gnoLightGridFirstSub(count); ++cell) gnoLightGridOpen(cell);
        state.capacity = state.forest.pairs;
        state.pairs.assign(state.capacity, GnoForestPair{0u, 0u});
        assign(Assign::emit, byCells, seed);
        for (const GnoViewSample& s : samples) gnoLightGridSeeSample(s.position);
        const auto eachPair = [&](const auto& what) {
            for (const GnoForestPair& pair : state.pairs) what(pair, casters[pair.caster], gnoFacing(light, casters[pair.caster]));
        };
        eachPair([](const GnoForestPair& pair, const GnoCaster& t, int facing) { gnoLightGridCount(pair.cell, t, facing); });
        const uint lists = gnoLightGridLists(count, ours.header.nests);
        for (uint list = 0; list < lists; ++list) gnoLightGridAllocate(list);
        ours.items.assign(ours.header.items, GnoLightGridItem{kPoison, kPoison});
        eachPair([](const GnoForestPair& pair, const GnoCaster& t, int facing) { gnoLightGridEmit(pair.cell, pair.caster, t, facing); });
        gnoLightGridSizes();
        for (uint list = 0; list < lists; ++list) gnoLightGridSort(list / 64, list % 64);
        for (uint group = 0; group < lists / 64; ++group) gnoLightGridFinish();
        gnoLightGridFinishPlanes();
        for (uint caster = 0; caster < casters.size(); ++caster) {
            const int facing = gnoFacing(light, casters[caster]);
            for (uint place = 0; facing != 0 && place < 4; ++place)
                ours.planes[4 * caster + place] = gnoLightGridPlane(light, casters[caster], facing, place);
        }
    }

    [[nodiscard]] bool ask(const GnoViewSample& sample, bool planes) override {
        const uint answer = planes ? gnoLightGridAnswer(sample) : computed::gnoLightGridAnswer(sample);
        if (answer == GNO_VISIBILITY_UNKNOWN) throw std::runtime_error("has no answer");
        return answer != GNO_VISIBILITY_LIT;
    }
    [[nodiscard]] const GnoLightGridHeader& header() const override { return ours.header; }
};

[[maybe_unused]] const bool kRegistered =
    (cpu::lightGridVariants().push_back({GNO_LIGHT_GRID_VARIANT, [] { return std::unique_ptr<cpu::LightGrid>(std::make_unique<Grid>()); }}), true);

}  // namespace
}  // namespace gno
