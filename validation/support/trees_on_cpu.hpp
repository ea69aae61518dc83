// SPDX-License-Identifier: MIT
// What the mirrors top_on_cpu.cpp, forest_on_cpu.cpp and light_grid_on_cpu.cpp share: memory that is checked at every access, the macros by which
// the GLSL text meets it, and the passes of trees and of cells. A mirror says before it includes this, last, which of them it runs:
//
//   GNO_ON_CPU_TREES   top/: build and queries; of a forest where cells are there, too
//   GNO_ON_CPU_CELLS   forest/: cells and assignment
//
// Everything is in an unnamed namespace and there is one `state`: include it in one .cpp per variant. Functions of a module stay unused in most.
#pragma once
#include <algorithm>
#include <bit>
#include <span>
#include <stdexcept>
#include <vector>

#include "glsl/forest/cells.h"
#include "glsl/top/node.h"
#include "validation/support/checked_array.hpp"
#include "validation/support/glsl_as_cpp.hpp"
#include "validation/support/top_on_cpu.hpp"

#if !defined(GNO_ON_CPU_TREES) || !defined(GNO_ON_CPU_CELLS)
#error "define GNO_ON_CPU_TREES and GNO_ON_CPU_CELLS, 0 or 1"
#endif
#ifndef GNO_TOP_WITH_SLABS
#define GNO_TOP_WITH_SLABS 0
#endif

#pragma GCC diagnostic ignored "-Wunused-function"
#ifdef __clang__
#pragma GCC diagnostic ignored "-Wunused-const-variable"
#endif

namespace gno {
namespace {

constexpr uint kPoison = 0xDEADBEEFu;  ///< memory that nobody has written

template <class T>
using Array = cpu::CheckedArray<T>;

/// Planes, read once per node that is visited: a build or a query that goes round in circles runs out of steps.
struct Planes : Array<vec4> {
    uint stepsLeft = 0;  ///< of the insertion or query under way
    vec4& operator[](uint index) {
        if (stepsLeft-- == 0) throw std::runtime_error("goes round in circles");
        return Array<vec4>::operator[](index);
    }
};

struct State {
    Array<GnoCaster> casters;
    vec4 light{0, 0, 0, 1};
    uint precision = GNO_PRECISION_CERTIFIED;
    // Trees
    Planes planes;
    Array<GnoTopLink> links;
    Array<GnoTopSlab> slabs;
    GnoTopHeader header{GNO_TOP_NONE, 0, 0, 0};
    uint depthTest = 1;
    cpu::TopAnswer answer;
    // Cells
    GnoForestGrid grid{};
    Array<GnoForestCell> cells;
    Array<GnoForestFew> few;
    Array<GnoForestPair> pairs;
    GnoForestHeader forest{};
    uint capacity = 0;
    bool viewCull = true, cover = true;
} state;

GnoTopNode loadNode(uint index) {
    const GnoTopLink& link = state.links[index];
    GnoTopNode node{};
    node.plane = state.planes[index];
    node.positiveChild = link.positiveChild;
    node.intersectionChild = link.intersectionChild;
    node.aux = link.aux;
    node.wedge = std::bit_cast<decltype(node.wedge)>(link.wedge);
    return node;
}

#define GNO_LIGHT state.light
#define GNO_LOAD_CASTER(index_) state.casters[index_]
#define GNO_PRECISION state.precision

#define GNO_CORE_COUNTERS_GLSL  // counters of our own: those of the module start as a GLSL constructor
#define GNO_COUNT(member_, amount_) Counter::member_(amount_)
#define GNO_COUNT_MAX(member_, value_) Counter::member_(value_)
struct Counter {
    static void visitedNodes(uint n) { state.answer.visitedNodes += n; }
    static void deepestStack(uint n) { state.answer.deepestStack = glm::max(state.answer.deepestStack, n); }
    static void stackOverflows(uint n) { state.answer.stackOverflows += n; }
    static void exactCalls(uint) {}
    static void buildSteps(uint) {}
    static void intersections(uint) {}
    static void dropped(uint) {}
};

#undef GNO_NAMESPACE_BEGIN
#undef GNO_NAMESPACE_END
#define GNO_NAMESPACE_BEGIN
#define GNO_NAMESPACE_END
#include "glsl/core/decide.glsl"
#include "glsl/core/orient3d.glsl"

#if GNO_ON_CPU_CELLS
#define GNO_FOREST_GRID state.grid
#define GNO_FOREST_CELLS state.cells
#define GNO_FOREST_FEW state.few
#define GNO_FOREST_PAIRS state.pairs
#define GNO_FOREST_CAPACITY state.capacity
#define GNO_FOREST_HEADER state.forest
#define GNO_FOREST_VIEW_CULL int(state.viewCull)
#define GNO_FOREST_USE_COVER int(state.cover)
#include "glsl/forest/assign.glsl"

/// What a frame starts from, seen by these samples.
void openCells(std::span<const GnoViewSample> samples) {
    state.cells.assign(gnoCellCount(state.grid.resolution, state.grid.faces), {kPoison, kPoison, kPoison, kPoison});
    state.few.assign(state.casters.size(), {kPoison, kPoison});
    for (uint cell = 0; cell < state.cells.size(); ++cell) gnoForestReset(cell);
    for (size_t i = 0; state.viewCull && i < samples.size(); i += 8) {  // eight to an invocation
        GnoForestSeen seen = gnoForestSeen();
        for (const GnoViewSample& s : samples.subspan(i, std::min<size_t>(8, samples.size() - i))) gnoForestSeeSample(seen, s.position);
        gnoForestTell(seen);
    }
}

/// Casters by the number of their cells, as sort.comp has them.
struct Lists {
    std::vector<uint> some, many;
};

Lists sortCasters() {
    Lists lists;
    for (uint caster = 0; caster < state.casters.size(); ++caster) {
        if (gnoFacing(state.light, state.casters[caster]) == 0) {
            gnoForestNone(caster);
            continue;
        }
        const uint size = gnoForestSort(caster, gnoCellSight(state.light, state.casters[caster]));
        if (size == GNO_FOREST_SOME_CELLS) lists.some.push_back(caster);
        if (size == GNO_FOREST_MANY_CELLS) lists.many.push_back(caster);
    }
    state.forest.some = uint(lists.some.size());
    state.forest.many = uint(lists.many.size());
    return lists;
}

enum class Assign { cover, count, emit };

/// A caster with many cells is shared by 64 lanes, any other has one invocation.
void assign(Assign what, const Lists& lists, uint seed) {
    const auto walk = [&](uint caster, uint lanes) {
        const GnoCellVolume v = gnoCellVolume(state.light, state.casters[caster], gnoFacing(state.light, state.casters[caster]));
        for (uint lane = 0; lane < lanes; ++lane) {
            if (what == Assign::cover) gnoForestCover(v, lane, lanes);
            if (what == Assign::count) gnoForestCount(v, lane, lanes);
            if (what == Assign::emit) gnoForestEmit(caster, v, lane, lanes);
        }
    };
    for (const uint caster : lists.many) walk(caster, 64);
    for (const uint n : cpu::insertionOrder(uint(lists.some.size()), seed)) walk(lists.some[n], 1);
    if (what == Assign::cover) return;
    for (const uint caster : cpu::insertionOrder(uint(state.casters.size()), seed)) {
        if (what == Assign::count)
            gnoForestCountFew(caster);
        else
            gnoForestEmitFew(caster);
    }
}
#endif

#if GNO_ON_CPU_TREES
#define GNO_TOP_PLANES state.planes
#define GNO_TOP_LINKS state.links
#if GNO_TOP_WITH_SLABS
#define GNO_TOP_SLABS state.slabs
#define GNO_TOP_LOAD_SLAB(index_) state.slabs[index_]
#define GNO_TOP_SLAB (state.precision == GNO_PRECISION_PUBLISHED ? 0 : 1)
#endif
#if GNO_ON_CPU_CELLS
#define GNO_TOP_CASTER_OF(block_) state.pairs[block_].caster
#define GNO_TOP_ROOT_OF(block_) state.cells[state.pairs[block_].cell].root
#define GNO_TOP_FIND_ROOT(q_) gnoForestRoot(state.cells[gnoCellOf(state.light, state.grid, q_)], gnoLightDepth(state.light, q_))
#else
#define GNO_TOP_ROOT state.header.root
#endif
#define GNO_TOP_HEADER state.header
#define GNO_TOP_STATE gnoTopState(state.header)
#define GNO_TOP_LOAD_NODE(index_) loadNode(index_)
#define GNO_TOP_LOAD_ANCESTOR(index_) state.links[((index_) & ~3u) + 1u].aux
#define GNO_TOP_LOAD_FLAGS(index_) state.links[((index_) & ~3u) + 2u].aux
#define GNO_TOP_DEPTH_TEST state.depthTest
#include "glsl/top/build.glsl"
#include "glsl/top/query_hybrid.glsl"
#include "glsl/top/query_stack.glsl"
#include "glsl/top/query_stackless.glsl"

/// Sets up every block, then inserts those of `order`, one after the other. `word`: of core/state.h.
void buildTrees(uint blocks, std::span<const uint> order, uint word) {
    state.header = {kPoison, kPoison, kPoison, kPoison};
    gnoTopBegin(word == gnoState(state.precision) ? blocks : 0, word);
    state.planes.assign(4 * size_t(blocks), vec4(uintBitsToFloat(kPoison)));
    state.links.assign(4 * size_t(blocks), GnoTopLink{kPoison, kPoison, kPoison, kPoison});
    state.slabs.assign(4 * size_t(blocks), GnoTopSlab{kPoison, kPoison, kPoison, kPoison});
    for (uint block = 0; block < blocks; ++block) {
        state.planes.stepsLeft = 4 * blocks + 64;
        gnoTopSetUp(block, gnoFacing(state.light, state.casters[GNO_TOP_CASTER_OF(block)]));
    }
    for (const uint block : order) {
        state.planes.stepsLeft = 4 * blocks + 64;
        gnoTopInsert(block);
    }
}

cpu::TopAnswer askTrees(cpu::TopQuery query, const GnoViewSample& sample) {
    state.answer = {};
    state.planes.stepsLeft = 4 * uint(state.planes.size()) + 64;
    state.depthTest = query == cpu::TopQuery::psv ? 0 : 1;
    switch (query) {
        case cpu::TopQuery::psv:
        case cpu::TopQuery::dPsv:
            state.answer.visibility = gnoTopStackAnswer(sample);
            break;
        case cpu::TopQuery::dStackless:
            state.answer.visibility = gnoTopStacklessAnswer(sample);
            break;
        case cpu::TopQuery::dHybrid:
            state.answer.visibility = gnoTopHybridAnswer(sample);
            break;
    }
    state.answer.inShadow = state.answer.visibility == GNO_VISIBILITY_SHADOW;
    return state.answer;
}
#endif

}  // namespace
}  // namespace gno
