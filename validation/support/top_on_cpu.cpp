// SPDX-License-Identifier: MIT
// One variant: GNO_TOP_VARIANT is its name. A variant of other text finds it first on its include path (-iquote).
// Everything is in an unnamed namespace, so that one program can hold many.
#include "validation/support/top_on_cpu.hpp"

#include <stdexcept>

#include "validation/support/glsl_as_cpp.hpp"

#ifndef GNO_TOP_VARIANT
#error "define GNO_TOP_VARIANT, a name"
#endif
#ifndef GNO_TOP_WITH_SLABS
#define GNO_TOP_WITH_SLABS 0
#endif
#ifndef GNO_TOP_STACK_SIZE
#define GNO_TOP_STACK_SIZE 32
#endif
#ifndef GNO_TOP_SHORT_STACK_SIZE
#define GNO_TOP_SHORT_STACK_SIZE 12
#endif

#pragma GCC diagnostic ignored "-Wunused-function"
#ifdef __clang__
#pragma GCC diagnostic ignored "-Wunused-const-variable"
#endif

namespace gno {
namespace {

struct State {
    std::vector<GnoCaster> casters;
    std::vector<vec4> planes;
    std::vector<GnoTopLink> links;
    std::vector<GnoTopSlab> slabs;
    GnoTopHeader header{GNO_TOP_NONE, 0, 0, 0};
    vec4 light{0, 0, 0, 1};
    uint precision = GNO_PRECISION_CERTIFIED;
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

struct Planes {
    vec4& operator[](uint index) const {
        countStep();
        return element(state.planes, index);
    }
} constexpr cpuPlanes;

struct Links {
    GnoTopLink& operator[](uint index) const { return element(state.links, index); }
} constexpr cpuLinks;

struct Slabs {
    GnoTopSlab& operator[](uint index) const { return element(state.slabs, index); }
} constexpr cpuSlabs;

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

#define GNO_TOP_PLANES cpuPlanes
#define GNO_TOP_LINKS cpuLinks
#if GNO_TOP_WITH_SLABS
#define GNO_TOP_SLABS cpuSlabs
#define GNO_TOP_LOAD_SLAB(index_) cpuSlabs[index_]
#define GNO_TOP_SLAB (state.precision == GNO_PRECISION_PUBLISHED ? 0 : 1)
#endif
#define GNO_TOP_HEADER state.header
#define GNO_TOP_ROOT state.header.root
#define GNO_TOP_LOAD_NODE(index_) loadNode(index_)
#define GNO_TOP_LOAD_ANCESTOR(index_) cpuLinks[((index_) & ~3u) + 1u].aux
#define GNO_TOP_LOAD_FLAGS(index_) cpuLinks[((index_) & ~3u) + 2u].aux
#define GNO_TOP_DEPTH_TEST state.depthTest
#define GNO_LIGHT state.light
#define GNO_LOAD_CASTER(index_) element(state.casters, index_)
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
#include "glsl/top/build.glsl"
#include "glsl/top/query_hybrid.glsl"
#include "glsl/top/query_stack.glsl"
#include "glsl/top/query_stackless.glsl"

class Tree final : public cpu::TopTree {
public:
    void build(std::span<const GnoCaster> casters, vec4 light, uint precision, std::span<const uint> order) override {
        const uint count = uint(casters.size());
        const uint poison = 0xDEADBEEFu;
        state.casters.assign(casters.begin(), casters.end());
        state.planes.assign(4 * casters.size(), vec4(uintBitsToFloat(poison)));
        state.links.assign(4 * casters.size(), GnoTopLink{poison, poison, poison, poison});
        state.slabs.assign(4 * casters.size(), GnoTopSlab{poison, poison, poison, poison});
        state.header = {GNO_TOP_NONE, count, 0, 0};
        state.light = light;
        state.precision = precision;
        for (uint caster = 0; caster < count; ++caster) {
            state.stepsLeft = 4 * count + 64;
            gnoTopSetUp(caster, gnoFacing(light, state.casters[caster]));
        }
        for (const uint caster : order) {
            state.stepsLeft = 4 * count + 64;
            gnoTopInsert(caster);
        }
    }

    cpu::TopAnswer ask(cpu::TopQuery query, const GnoViewSample& sample) override {
        state.answer = {};
        state.stepsLeft = 16 * uint(state.casters.size()) + 64;
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

    [[nodiscard]] const std::vector<vec4>& planes() const override { return state.planes; }
    [[nodiscard]] const std::vector<GnoTopLink>& links() const override { return state.links; }
    [[nodiscard]] const GnoTopHeader& header() const override { return state.header; }
    [[nodiscard]] bool decide(vec4 light, const GnoCaster& caster, vec3 p, uint precision) const override {
        return gnoDecideInShadow(light, caster, p, precision);
    }
    [[nodiscard]] int facing(vec4 light, const GnoCaster& caster) const override { return gnoFacing(light, caster); }
};

[[maybe_unused]] const bool kRegistered =
    (cpu::topVariants().push_back({GNO_TOP_VARIANT, [] { return std::unique_ptr<cpu::TopTree>(std::make_unique<Tree>()); }}), true);

}  // namespace
}  // namespace gno
