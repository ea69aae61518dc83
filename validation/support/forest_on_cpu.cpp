// SPDX-License-Identifier: MIT
// One variant: GNO_FOREST_VARIANT is its name. A variant of other text finds it first on its include path (-iquote).
// Everything is in an unnamed namespace, so that one program can hold many.
#include "validation/support/forest_on_cpu.hpp"

#include <stdexcept>

#include "validation/support/glsl_as_cpp.hpp"

#ifndef GNO_FOREST_VARIANT
#error "define GNO_FOREST_VARIANT, a name"
#endif
#define GNO_TOP_STACK_SIZE 32
#define GNO_TOP_SHORT_STACK_SIZE 2

#pragma GCC diagnostic ignored "-Wunused-function"
#ifdef __clang__
#pragma GCC diagnostic ignored "-Wunused-const-variable"
#endif

namespace gno {
namespace {

struct State {
    std::vector<GnoCaster> casters;
    GnoForestGrid grid{};
    std::vector<GnoForestCell> cells;
    std::vector<GnoForestFew> few;
    std::vector<GnoForestPair> pairs;
    GnoForestHeader header{};
    std::vector<vec4> planes;
    std::vector<GnoTopLink> links;
    vec4 light{0, 0, 0, 1};
    cpu::ForestChoice choice;
    uint capacity = 0;
    uint depthTest = 1;
    uint stepsLeft = 0;  ///< of the insertion or query under way
    cpu::TopAnswer answer;
} state;

void countStep() {
    if (state.stepsLeft-- == 0) throw std::runtime_error("goes round in circles");
}

template <class T>
T& element(std::vector<T>& v, uint index) {
    if (index >= v.size()) throw std::runtime_error("reads outside an array");
    return v[index];
}

struct Cells {
    GnoForestCell& operator[](uint index) const { return element(state.cells, index); }
} constexpr cpuCells;

struct Few {
    GnoForestFew& operator[](uint index) const { return element(state.few, index); }
} constexpr cpuFew;

struct Pairs {
    GnoForestPair& operator[](uint index) const { return element(state.pairs, index); }
} constexpr cpuPairs;

struct Planes {
    vec4& operator[](uint index) const {
        countStep();
        return element(state.planes, index);
    }
} constexpr cpuPlanes;

struct Links {
    GnoTopLink& operator[](uint index) const { return element(state.links, index); }
} constexpr cpuLinks;

GnoTopNode loadNode(uint index) {
    const GnoTopLink& link = cpuLinks[index];
    GnoTopNode node{};
    node.plane = cpuPlanes[index];
    node.positiveChild = link.positiveChild;
    node.intersectionChild = link.intersectionChild;
    node.aux = link.aux;
    node.wedge = std::bit_cast<decltype(node.wedge)>(link.wedge);
    return node;
}

#define GNO_FOREST_GRID state.grid
#define GNO_FOREST_CELLS cpuCells
#define GNO_FOREST_FEW cpuFew
#define GNO_FOREST_PAIRS cpuPairs
#define GNO_FOREST_CAPACITY state.capacity
#define GNO_FOREST_HEADER state.header
#define GNO_FOREST_VIEW_CULL int(state.choice.viewCull)
#define GNO_FOREST_USE_COVER int(state.choice.cover)
#define GNO_TOP_PLANES cpuPlanes
#define GNO_TOP_LINKS cpuLinks
#define GNO_TOP_CASTER_OF(block_) cpuPairs[block_].caster
#define GNO_TOP_ROOT_OF(block_) cpuCells[cpuPairs[block_].cell].root
#define GNO_TOP_FIND_ROOT(q_) gnoForestRoot(cpuCells[gnoCellOf(state.light, state.grid, q_)], gnoLightDepth(state.light, q_))
#define GNO_TOP_LOAD_NODE(index_) loadNode(index_)
#define GNO_TOP_LOAD_ANCESTOR(index_) cpuLinks[((index_) & ~3u) + 1u].aux
#define GNO_TOP_LOAD_FLAGS(index_) cpuLinks[((index_) & ~3u) + 2u].aux
#define GNO_TOP_DEPTH_TEST state.depthTest
#define GNO_LIGHT state.light
#define GNO_LOAD_CASTER(index_) element(state.casters, index_)
#define GNO_PRECISION state.choice.precision

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
#include "glsl/forest/assign.glsl"
#include "glsl/top/build.glsl"
#include "glsl/top/query_hybrid.glsl"
#include "glsl/top/query_stack.glsl"
#include "glsl/top/query_stackless.glsl"

/// Step 2 as the examples have it: casters by the number of their cells.
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
    state.header.some = uint(lists.some.size());
    state.header.many = uint(lists.many.size());
    return lists;
}

/// Steps 3, 4 and 6: a caster with many cells is shared by 64 lanes, any other has one invocation.
void step(uint which, const Lists& lists) {
    const auto assign = [&](uint caster, uint lanes) {
        const GnoCellVolume v = gnoCellVolume(state.light, state.casters[caster], gnoFacing(state.light, state.casters[caster]));
        for (uint lane = 0; lane < lanes; ++lane) {
            if (which == 3) gnoForestCover(v, lane, lanes);
            if (which == 4) gnoForestCount(v, lane, lanes);
            if (which == 6) gnoForestEmit(caster, v, lane, lanes);
        }
    };
    for (const uint caster : lists.many) assign(caster, 64);
    for (const uint n : cpu::insertionOrder(uint(lists.some.size()), state.choice.seed)) assign(lists.some[n], 1);
    if (which == 3) return;
    for (const uint caster : cpu::insertionOrder(uint(state.casters.size()), state.choice.seed)) {
        if (which == 4)
            gnoForestCountFew(caster);
        else
            gnoForestEmitFew(caster);
    }
}

class Tree final : public cpu::Forest {
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
        const uint count = uint(casters.size());
        const uint poison = 0xDEADBEEFu;
        state.casters.assign(casters.begin(), casters.end());
        state.grid = grid;
        state.light = light;
        state.choice = choice;
        state.cells.assign(gnoCellCount(grid.resolution, grid.faces), {0, GNO_FOREST_NONE, 0, GNO_FOREST_NONE});
        state.few.assign(count, {poison, poison});
        state.header = {};
        for (size_t i = 0; choice.viewCull && i < samples.size(); i += 8) {  // eight to an invocation
            GnoForestSeen seen = gnoForestSeen();
            for (size_t n = i; n < std::min(samples.size(), i + 8); ++n) gnoForestSeeSample(seen, samples[n].position);
            gnoForestTell(seen);
        }
        const Lists lists = sortCasters();
        if (choice.cover) step(3, lists);
        step(4, lists);
        for (uint cell = 0; cell < state.cells.size(); ++cell) gnoForestAllocate(cell);
        state.capacity = std::min(choice.capacity, state.header.pairs);
        gnoForestSizes();
        state.pairs.assign(state.capacity, {GNO_FOREST_NONE, GNO_FOREST_NONE});
        step(6, lists);
        state.planes.assign(4 * size_t(state.capacity), vec4(uintBitsToFloat(poison)));
        state.links.assign(4 * size_t(state.capacity), GnoTopLink{poison, poison, poison, poison});
        for (uint block = 0; block < state.capacity; ++block) {
            state.stepsLeft = 4 * state.capacity + 64;
            gnoTopSetUp(block, gnoFacing(light, element(state.casters, state.pairs[block].caster)));
        }
        for (uint block = 0; block < state.capacity; ++block) {
            state.stepsLeft = 4 * state.capacity + 64;
            gnoTopInsert(block);
        }
    }

    cpu::TopAnswer ask(cpu::TopQuery query, const GnoViewSample& sample) override {
        state.answer = {};
        state.stepsLeft = 16 * state.capacity + 64;
        state.depthTest = query == cpu::TopQuery::psv ? 0 : 1;
        switch (query) {
            case cpu::TopQuery::psv:
            case cpu::TopQuery::dPsv:
                state.answer.inShadow = gnoTopQueryStack(sample);
                break;
            case cpu::TopQuery::dStackless:
                state.answer.inShadow = gnoTopQueryStackless(sample);
                break;
            case cpu::TopQuery::dHybrid:
                state.answer.inShadow = gnoTopQueryHybrid(sample);
                break;
        }
        return state.answer;
    }

    [[nodiscard]] const GnoForestHeader& header() const override { return state.header; }
    [[nodiscard]] const std::vector<GnoForestCell>& cells() const override { return state.cells; }
    [[nodiscard]] const std::vector<GnoForestPair>& pairs() const override { return state.pairs; }
};

[[maybe_unused]] const bool kRegistered =
    (cpu::forestVariants().push_back({GNO_FOREST_VARIANT, [] { return std::unique_ptr<cpu::Forest>(std::make_unique<Tree>()); }}), true);

}  // namespace
}  // namespace gno
