// SPDX-License-Identifier: MIT
// One variant: GNO_FOREST_VARIANT is its name. A variant of other text finds it first on its include path (-iquote).
// Everything is in an unnamed namespace, so that one program can hold many.
#include "validation/support/forest_on_cpu.hpp"

#include <numeric>

#ifndef GNO_FOREST_VARIANT
#error "define GNO_FOREST_VARIANT, a name"
#endif
#define GNO_TOP_STACK_SIZE 32
#define GNO_TOP_SHORT_STACK_SIZE 2
#define GNO_ON_CPU_TREES 1
#define GNO_ON_CPU_CELLS 1
#include "validation/support/trees_on_cpu.hpp"

namespace gno {
namespace {

class Trees final : public cpu::Forest {
public:
    [[nodiscard]] uint cellOf(vec4 light, const GnoForestGrid& grid, vec3 p) const override {
        return gnoCellOf(light, grid, gnoFromLight(light, p));
    }
    [[nodiscard]] float depth(vec4 light, vec3 p) const override { return gnoLightDepth(light, gnoFromLight(light, p)); }
    [[nodiscard]] int facing(vec4 light, const GnoCaster& caster) const override { return gnoFacing(light, caster); }

    [[nodiscard]] cpu::CasterCells cellsOf(vec4 light, const GnoForestGrid& grid, const GnoCaster& caster) const override {
        const GnoCellVolume v = gnoCellVolume(light, caster, gnoFacing(light, caster));
        cpu::CasterCells cells;
        for (uint face = 0; face < grid.faces; ++face)
            cells.rectangles.push_back(face >= v.face && face < v.faceEnd ? gnoCellRectangle(light, grid, face, v) : uvec4(0u));
        cells.least = v.least;
        cells.most = v.most;
        cells.missed = [=](uint face, uvec2 at) { return gnoCellMissed(light, grid, face, at, v); };
        cells.covered = [=](uint face, uvec2 at) { return gnoCellCovered(light, grid, face, at, v); };
        return cells;
    }

    void build(std::span<const GnoCaster> casters, vec4 light, const GnoForestGrid& grid, std::span<const GnoViewSample> samples,
               const cpu::ForestChoice& choice) override {
        state.casters.assign(casters.begin(), casters.end());
        state.grid = grid;
        state.light = light;
        state.precision = choice.precision;
        state.viewCull = choice.viewCull;
        state.cover = choice.cover;
        openCells(samples);
        const Lists lists = sortCasters();
        if (choice.cover) assign(Assign::cover, lists, choice.seed);
        assign(Assign::count, lists, choice.seed);
        for (uint cell = 0; cell < state.cells.size(); ++cell) gnoForestAllocate(cell);
        state.capacity = std::min(choice.capacity, state.forest.pairs);
        gnoForestSizes();
        state.pairs.assign(state.capacity, {GNO_FOREST_NONE, GNO_FOREST_NONE});
        assign(Assign::emit, lists, choice.seed);
        std::vector<uint> order(state.capacity);
        std::iota(order.begin(), order.end(), 0u);
        buildTrees(state.capacity, order, gnoForestState(state.forest, state.capacity, choice.precision));
    }
    cpu::TopAnswer ask(cpu::TopQuery query, const GnoViewSample& sample) override { return askTrees(query, sample); }

    [[nodiscard]] const GnoForestHeader& header() const override { return state.forest; }
    [[nodiscard]] const std::vector<GnoForestCell>& cells() const override { return state.cells; }
    [[nodiscard]] const std::vector<GnoForestPair>& pairs() const override { return state.pairs; }
};

[[maybe_unused]] const bool kRegistered =
    (cpu::forestVariants().push_back({GNO_FOREST_VARIANT, [] { return std::unique_ptr<cpu::Forest>(std::make_unique<Trees>()); }}), true);

}  // namespace
}  // namespace gno
