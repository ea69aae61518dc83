// SPDX-License-Identifier: MIT
// One variant: GNO_LIGHT_BVH_VARIANT is its name. A variant of other text finds it first on its include path (-iquote).
// Everything is in an unnamed namespace, so that one program can hold many.
#include "validation/support/light_bvh_on_cpu.hpp"

#include <algorithm>
#include <numeric>

#include "validation/support/checked_array.hpp"
#include "validation/support/glsl_as_cpp.hpp"
#include "validation/support/work_group.hpp"

#ifndef GNO_LIGHT_BVH_VARIANT
#error "define GNO_LIGHT_BVH_VARIANT, a name"
#endif

#pragma GCC diagnostic ignored "-Wunused-function"

namespace gno {
namespace {

using cpu::barrier;
using cpu::WorkGroup;

#undef GNO_NAMESPACE_BEGIN
#undef GNO_NAMESPACE_END
#define GNO_NAMESPACE_BEGIN
#define GNO_NAMESPACE_END
#include "glsl/rivals/light_bvh.h"

constexpr uint kPoison = 0xDEADBEEFu;

struct State {
    cpu::CheckedArray<GnoCaster> casters;
    cpu::CheckedArray<uint> masks, sums, keys, order, parents;
    cpu::CheckedArray<GnoLightBvhLevel> levels;
    cpu::CheckedArray<GnoLightBvhBox> references, boxes, splits;
    cpu::CheckedArray<GnoLightBvhNode> nodes;
    GnoLightBvhHeader header{};
    GnoForestGrid grid{};
    vec4 light{0, 0, 0, 1};
    cpu::LightBvhAnswer answer;
    uint stepsLeft = 0;
} state;

GnoLightBvhNode loadNode(uint index) {
    if (state.stepsLeft-- == 0) throw std::runtime_error("goes round in circles");
    return state.nodes[index];
}

#define GNO_LIGHT_BVH_STATE state.header.state
#define GNO_LIGHT_BVH_GRID state.grid
#define GNO_LIGHT_BVH_MASKS state.masks
#define GNO_LIGHT_BVH_SUMS state.sums
#define GNO_LIGHT_BVH_HEADER state.header
#define GNO_LIGHT_BVH_LEVEL_TABLE state.levels
#define GNO_LIGHT_BVH_REFERENCES state.references
#define GNO_LIGHT_BVH_CAPACITY uint(state.references.size())
#define GNO_LIGHT_BVH_KEYS state.keys
#define GNO_LIGHT_BVH_ORDER state.order
#define GNO_LIGHT_BVH_BOXES state.boxes
#define GNO_LIGHT_BVH_SPLITS state.splits
#define GNO_LIGHT_BVH_NODES state.nodes
#define GNO_LIGHT_BVH_PARENTS state.parents
#define GNO_LIGHT_BVH_ROOT(face_) state.header.roots[face_]
#define GNO_LIGHT_BVH_LOAD_NODE(index_) loadNode(index_)
#define GNO_LIGHT_BVH_LOAD_PARENT(index_) state.parents[index_]
#define GNO_PREFIX_WORDS state.sums
#define GNO_LIGHT state.light
#define GNO_LOAD_CASTER(index_) state.casters[index_]
#define GNO_CORE_COUNTERS_GLSL  // counters of our own: those of the module start as a GLSL constructor
#define GNO_COUNT(member_, amount_) Counter::member_(amount_)
#define GNO_COUNT_MAX(member_, value_) Counter::member_(value_)
struct Counter {
    static void visitedNodes(uint n) { state.answer.visitedNodes += n; }
    static void deepestStack(uint n) { state.answer.deepestStack = glm::max(state.answer.deepestStack, n); }
    static void stackOverflows(uint n) { state.answer.stackOverflows += n; }
    static void exactCalls(uint) {}
};

#define shared static
#include "glsl/core/orient3d.glsl"
#include "glsl/rivals/light_bvh_build.glsl"
#undef shared
#define GNO_LIGHT_BVH_STACK_SIZE 32
#include "glsl/rivals/light_bvh_query.glsl"
#undef GNO_LIGHT_BVH_STACK_SIZE
#undef GNO_RIVALS_LIGHT_BVH_QUERY_GLSL
// The same with a stack of one entry, under other names.
#define gnoLightBvhShadows_ oneEntry_gnoLightBvhShadows_
#define gnoLightBvhMet_ oneEntry_gnoLightBvhMet_
#define gnoLightBvhStacklessAnswer oneEntry_gnoLightBvhStacklessAnswer
#define gnoLightBvhAnswer oneEntry_gnoLightBvhAnswer
#define gnoLightBvhQueryStackless oneEntry_gnoLightBvhQueryStackless
#define gnoLightBvhQuery oneEntry_gnoLightBvhQuery
#define GNO_LIGHT_BVH_STACK_SIZE 1
#include "glsl/rivals/light_bvh_query.glsl"
#undef gnoLightBvhShadows_
#undef gnoLightBvhMet_
#undef gnoLightBvhStacklessAnswer
#undef gnoLightBvhAnswer
#undef gnoLightBvhQueryStackless
#undef gnoLightBvhQuery

class OnCpu final : public cpu::LightBvh {
public:
    void build(std::span<const GnoCaster> casters, vec4 light, const GnoForestGrid& grid, uint capacity, bool backwards) override {
        backwards_ = backwards;
        state.casters.assign(casters.begin(), casters.end());
        state.light = light;
        state.grid = grid;
        const auto count = uint(casters.size());
        const uint groups = gnoLightBvhGroups(count);
        state.masks.keep(count, kPoison);
        state.sums.keep(groups, kPoison);
        state.levels.keep(GNO_LIGHT_BVH_LEVELS, {kPoison, kPoison, kPoison, kPoison, kPoison});
        std::vector<int> facing(count);
        std::vector<uint> faces(64 * groups, 0);
        for (uint i = 0; i < count; ++i) {
            facing[i] = gnoFacing(light, casters[i]);
            if (facing[i] != 0) faces[i] = gnoLightBvhFaces(light, grid, gnoLightBvhCaster(light, casters[i], facing[i]));
        }
        const auto countAll = [&] {
            eachGroup(groups, [&](uint group, uint i) { gnoLightBvhCount(64 * group + i, faces[64 * group + i], group, i); });
            eachGroup(1, [&](uint, uint i) {
                const uint references = gnoArrayPrefix(groups, i);
                if (i == 0u) gnoLightBvhBegin(references);
            });
        };
        countAll();
        allocate(capacity > 0 ? capacity : state.header.references);
        countAll();
        std::vector<uint> first(64 * groups);
        eachGroup(groups, [&](uint group, uint i) {
            const uint caster = 64 * group + i;
            first[caster] = gnoLightBvhFirst(caster < count ? state.masks[caster] : 0u, group, i);
        });
        each(count, [&](uint i) {
            if (state.masks[i] != 0u) gnoLightBvhEmit(i, state.masks[i], gnoLightBvhCaster(light, casters[i], facing[i]), first[i]);
        });
        sort();
        const uint listed = 64 * state.header.groupsOfReferences;
        each(listed, [](uint i) { gnoLightBvhLeaf(i); });
        uint row = 1;
        for (uint boxes = uint(state.references.size()); boxes > 1; ++row) {
            boxes = gnoLightBvhNextRow(boxes);
            each(64 * gnoLightBvhGroups(boxes), [&](uint i) { gnoLightBvhUp(row, i); });
        }
        each(listed, [](uint i) { gnoLightBvhSplit(i); });
        for (uint level = 0; level < GNO_LIGHT_BVH_LEVELS; ++level)
            each(64 * state.levels[level].groups, [&](uint i) { gnoLightBvhCollapse(level, i); });
    }

    [[nodiscard]] cpu::LightBvhAnswer ask(cpu::LightBvhQuery query, const GnoViewSample& sample) override {
        state.answer = {};
        state.stepsLeft = 8 * uint(state.nodes.size()) + 8;  // one entry: once to its end, and once again without a stack
        state.answer.visibility = query == cpu::LightBvhQuery::stackless    ? gnoLightBvhStacklessAnswer(sample)
                                  : query == cpu::LightBvhQuery::shortStack ? oneEntry_gnoLightBvhAnswer(sample)
                                                                            : gnoLightBvhAnswer(sample);
        return state.answer;
    }

    [[nodiscard]] uint references() const override { return state.header.references; }
    [[nodiscard]] std::array<uint, 6> roots() const override { return std::to_array(state.header.roots); }
    [[nodiscard]] std::vector<cpu::LightBvhNode> nodes() const override {
        std::vector<cpu::LightBvhNode> all;
        for (const GnoLightBvhNode& node : state.nodes) all.push_back({node.low, node.high, node.least, node.link});
        return all;
    }
    [[nodiscard]] const std::vector<uint>& parents() const override { return state.parents; }

    [[nodiscard]] std::string lost(vec4 light, const GnoForestGrid& grid, const GnoCaster& caster, int facing, vec3 p) const override {
        const vec3 q = gnoFromLight(light, p);
        const uvec3 at = gnoCellAt(light, grid, q);
        const GnoLightBvhCaster seen = gnoLightBvhCaster(light, caster, facing);
        if ((gnoLightBvhFaces(light, grid, seen) & (1u << at.z)) == 0u) return "no reference on the sample's face";
        uint low = 0, high = 0;
        if (!gnoLightBvhBounds(light, grid, at.z, seen, low, high)) return "no cells on the sample's face";
        if (!gnoLightBvhHolds(low, high, at.x | (at.y << 16))) return "the sample's cell is not in the bounds";
        return gnoTopLeastDepth(light, caster) <= gnoLightDepth(light, q) ? "" : "the caster is said to be farther than the sample";
    }

private:
    template <class Work>
    void each(uint count, const Work& work) const {
        for (uint i = 0; i < count; ++i) work(backwards_ ? count - 1 - i : i);
    }
    template <class Work>
    void eachGroup(uint groups, const Work& work) const {
        each(groups, [&](uint group) {
            WorkGroup::run(
                64, [&](unsigned i) { work(group, i); }, backwards_ ? 1 : 0);
        });
    }

    static void allocate(uint capacity) {
        const GnoLightBvhBox box{kPoison, kPoison, uintBitsToFloat(kPoison), kPoison};
        for (auto* boxes : {&state.references, &state.splits}) boxes->keep(capacity, box);
        state.boxes.keep(gnoLightBvhBoxes(capacity), box);
        for (auto* words : {&state.keys, &state.order}) words->keep(capacity, kPoison);
        const uint nodes = gnoLightBvhNodes(capacity);
        state.nodes.keep(nodes, {uvec4(kPoison), uvec4(kPoison), vec4(uintBitsToFloat(kPoison)), uvec4(kPoison)});
        state.parents.keep(nodes, kPoison);
    }

    static void sort() {
        const uint length = glm::min(state.header.references, uint(state.keys.size()));
        std::vector<uint> places(length);
        std::iota(places.begin(), places.end(), 0u);
        const auto keys = state.keys, order = state.order;
        std::stable_sort(places.begin(), places.end(), [&](uint i, uint k) { return keys.at(i) < keys.at(k); });
        for (uint i = 0; i < length; ++i) {
            state.keys[i] = keys.at(places[i]);
            state.order[i] = order.at(places[i]);
        }
    }

    bool backwards_ = false;
};

[[maybe_unused]] const bool kRegistered =
    (cpu::lightBvhVariants().push_back({GNO_LIGHT_BVH_VARIANT, [] { return std::unique_ptr<cpu::LightBvh>(std::make_unique<OnCpu>()); }}), true);

}  // namespace
}  // namespace gno
