// SPDX-License-Identifier: MIT
// One variant: GNO_LIGHT_GRID_VARIANT is its name. A variant of other text finds it first on its include path (-iquote).
// Everything is in an unnamed namespace, so that one program can hold many.
#include "validation/support/light_grid_on_cpu.hpp"

#include <stdexcept>

#include "validation/support/glsl_as_cpp.hpp"

#ifndef GNO_LIGHT_GRID_VARIANT
#error "define GNO_LIGHT_GRID_VARIANT, a name"
#endif

#pragma GCC diagnostic ignored "-Wunused-function"
#ifdef __clang__
#pragma GCC diagnostic ignored "-Wunused-const-variable"
#endif

namespace gno {
namespace {

template <class T>
struct Array : std::vector<T> {
    T& operator[](uint index) {
        if (index >= this->size()) throw std::runtime_error("reads outside an array");
        return std::vector<T>::operator[](index);
    }
};

struct State {
    Array<GnoCaster> casters;
    Array<GnoForestCell> cells;
    Array<GnoForestFew> few;
    Array<GnoForestPair> pairs;
    Array<GnoLightGridList> lists;
    Array<uint> depths;
    Array<GnoLightGridItem> items;
    Array<vec4> planes;
    GnoForestGrid grid{};
    GnoForestHeader forest{};
    GnoLightGridHeader header{};
    vec4 light{0, 0, 0, 1};
    uint nest = 8;
} state;

#define GNO_FOREST_GRID state.grid
#define GNO_FOREST_CELLS state.cells
#define GNO_FOREST_FEW state.few
#define GNO_FOREST_PAIRS state.pairs
#define GNO_FOREST_CAPACITY uint(state.pairs.size())
#define GNO_FOREST_HEADER state.forest
#define GNO_LIGHT_GRID_LISTS state.lists
#define GNO_LIGHT_GRID_DEPTHS state.depths
#define GNO_LIGHT_GRID_NESTS uint(state.depths.size() / GNO_LIGHT_GRID_GROUP)
#define GNO_LIGHT_GRID_ITEMS state.items
#define GNO_LIGHT_GRID_CAPACITY uint(state.items.size())
#define GNO_LIGHT_GRID_HEADER state.header
#define GNO_LIGHT_GRID_NEST state.nest
#define GNO_LIGHT_GRID_SHORT 0xFFFFFFFFu
#define GNO_LIGHT_GRID_LOAD_PLANE(index_) state.planes[index_]
#define GNO_LIGHT state.light
#define GNO_LOAD_CASTER(index_) state.casters[index_]
#define GNO_CORE_COUNTERS_GLSL  // none here
#define GNO_COUNT(member_, amount_)
#define GNO_COUNT_MAX(member_, value_)

#define shared static
void barrier() {}
void memoryBarrierBuffer() {}

#undef GNO_NAMESPACE_BEGIN
#undef GNO_NAMESPACE_END
#define GNO_NAMESPACE_BEGIN
#define GNO_NAMESPACE_END
#include "glsl/core/decide.glsl"
#include "glsl/core/orient3d.glsl"
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
        state.nest = nest;
        const uint count = gnoCellCount(grid.resolution, grid.faces);
        state.cells.assign(count, GnoForestCell{0u, GNO_FOREST_NONE, 0u, GNO_FOREST_NONE});
        state.lists.assign(gnoLightGridLists(count, count), GnoLightGridList{0xDEADBEEFu, 0xDEADBEEFu});
        state.depths.assign(64 * count, 0xDEADBEEFu);
        state.planes.assign(4 * casters.size(), vec4(0));
        state.forest = {};
        GnoForestSeen seen = gnoForestSeen();
        for (const GnoViewSample& s : samples) gnoForestSeeSample(seen, s.position);
        gnoForestTell(seen);
        const auto each = [&](const auto& what) {
            for (uint caster = 0; caster < casters.size(); ++caster)
                if (const int facing = gnoFacing(light, casters[caster]); facing != 0) what(caster, facing);
        };
        state.few.assign(casters.size(), GnoForestFew{0u, 0u});
        std::vector<uint> sizes(casters.size(), GNO_FOREST_FEW_CELLS);
        each([&](uint caster, int) { sizes[caster] = gnoForestSort(caster, gnoCellSight(light, casters[caster])); });
        const auto assign = [&](const auto& few, const auto& more) {
            each([&](uint caster, int facing) {
                if (sizes[caster] == GNO_FOREST_FEW_CELLS)
                    few(caster);
                else
                    more(caster, gnoCellVolume(light, casters[caster], facing));
            });
        };
        assign([](uint) {}, [](uint, const GnoCellVolume& v) { gnoForestCover(v, 0u, 1u); });
        assign([](uint caster) { gnoForestCountFew(caster); }, [](uint, const GnoCellVolume& v) { gnoForestCount(v, 0u, 1u); });
        gnoLightGridReset();
        for (uint cell = 0; cell < gnoLightGridFirstSub(count); ++cell) gnoLightGridOpen(cell);
        state.pairs.assign(state.forest.pairs, GnoForestPair{0u, 0u});
        assign([](uint caster) { gnoForestEmitFew(caster); }, [](uint caster, const GnoCellVolume& v) { gnoForestEmit(caster, v, 0u, 1u); });
        for (const GnoViewSample& s : samples) gnoLightGridSeeSample(s.position);
        const auto eachPair = [&](const auto& what) {
            for (const GnoForestPair& pair : state.pairs) what(pair, casters[pair.caster], gnoFacing(light, casters[pair.caster]));
        };
        eachPair([](const GnoForestPair& pair, const GnoCaster& t, int facing) { gnoLightGridCount(pair.cell, t, facing); });
        const uint lists = gnoLightGridLists(count, state.header.nests);
        for (uint list = 0; list < lists; ++list) gnoLightGridAllocate(list);
        state.items.assign(state.header.items, GnoLightGridItem{0xDEADBEEFu, 0xDEADBEEFu});
        eachPair([](const GnoForestPair& pair, const GnoCaster& t, int facing) { gnoLightGridEmit(pair.cell, pair.caster, t, facing); });
        for (uint list = 0; list < lists; ++list) gnoLightGridSort(list / 64, list % 64);
        each([&](uint caster, int facing) {
            for (uint place = 0; place < 4; ++place) state.planes[4 * caster + place] = gnoLightGridPlane(light, casters[caster], facing, place);
        });
    }

    [[nodiscard]] bool ask(const GnoViewSample& sample, bool planes) override {
        return planes ? gnoLightGridQuery(sample) : computed::gnoLightGridQuery(sample);
    }
    [[nodiscard]] const GnoLightGridHeader& header() const override { return state.header; }
};

[[maybe_unused]] const bool kRegistered =
    (cpu::lightGridVariants().push_back({GNO_LIGHT_GRID_VARIANT, [] { return std::unique_ptr<cpu::LightGrid>(std::make_unique<Grid>()); }}), true);

}  // namespace
}  // namespace gno
