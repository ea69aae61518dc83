// SPDX-License-Identifier: MIT
// One variant: GNO_CLUSTER_VARIANT is its name. A variant of other text finds it first on its include path (-iquote).
// Everything is in an unnamed namespace, so that one program can hold many.
#include "validation/support/cluster_on_cpu.hpp"

#include <bit>
#include <stdexcept>

#include "glsl/clusters/cluster.h"
#include "host_min/techniques/cluster_frame.hpp"
#include "validation/support/checked_array.hpp"
#include "validation/support/glsl_as_cpp.hpp"
#include "validation/support/work_group.hpp"

#ifndef GNO_CLUSTER_VARIANT
#error "define GNO_CLUSTER_VARIANT, a name"
#endif

#pragma GCC diagnostic ignored "-Wunused-function"

namespace gno {
namespace {

using cpu::barrier;
using cpu::WorkGroup;
template <class T>
using Array = cpu::CheckedArray<T>;

struct State {
    GnoClusterFrame frame{};
    GnoClusterLayout tree{};
    GnoClusterHeader header{};
    Array<float> slices, low, high;
    Array<uint> masks, shade;
    Array<uvec2> pointers, info, jobs;
    Array<vec4> volumes;
    Array<GnoCaster> casters;
    Array<GnoViewSample> samples;
    vec4 light{0, 0, 0, 1};
    uint precision = GNO_PRECISION_CERTIFIED;
} state;

// One invocation of a subgroup of 64 is active, and it is not the first.
constexpr uint gl_SubgroupSize = 64, gl_SubgroupInvocationID = 37;
bool subgroupElect() { return true; }
uint subgroupBroadcastFirst(uint x) { return x; }
uvec4 subgroupBallot(bool x) { return uvec4(0u, x ? 1u << (gl_SubgroupInvocationID - 32u) : 0u, 0u, 0u); }
uint subgroupBallotBitCount(uvec4 x) { return uint(std::popcount(x.x) + std::popcount(x.y)); }
uint subgroupBallotExclusiveBitCount(uvec4 x) {
    return uint(std::popcount(x.x) + std::popcount(x.y & ((1u << (gl_SubgroupInvocationID - 32u)) - 1u)));
}

#define GNO_CLUSTER_FRAME state.frame
#define GNO_CLUSTER_LAYOUT state.tree
#define GNO_CLUSTER_HEADER state.header
#define GNO_CLUSTER_STATE gnoClusterState(state.header, state.frame, state.tree)
#define GNO_CLUSTER_FORM state.tree.form
#define GNO_CLUSTER_SLICES state.slices
#define GNO_CLUSTER_MASKS state.masks
#define GNO_CLUSTER_SHADE state.shade
#define GNO_CLUSTER_LOW state.low
#define GNO_CLUSTER_HIGH state.high
#define GNO_CLUSTER_POINTERS state.pointers
#define GNO_CLUSTER_VOLUMES state.volumes
#define GNO_CLUSTER_INFO state.info
#define GNO_CLUSTER_JOBS state.jobs
#define GNO_CLUSTER_LOAD_SAMPLE(pixel_) state.samples[size_t((pixel_).y) * state.frame.size.x + size_t((pixel_).x)]
#define GNO_LIGHT state.light
#define GNO_LOAD_CASTER(index_) state.casters[index_]
#define GNO_PRECISION state.precision
#define GNO_CORE_COUNTERS_GLSL  // those of the module start as a GLSL constructor
#define GNO_COUNT(member_, amount_)

#undef GNO_NAMESPACE_BEGIN
#undef GNO_NAMESPACE_END
#define GNO_NAMESPACE_BEGIN
#define GNO_NAMESPACE_END
#define shared static
#include "glsl/clusters/build.glsl"
#include "glsl/clusters/merge.glsl"
#include "glsl/clusters/traverse.glsl"
#include "glsl/clusters/volume.glsl"
#undef shared

class Family final : public cpu::ClusterFamily {
public:
    std::vector<uint32_t> run(const test::CameraView& view, const cpu::ClusterChoice& choice) override {
        prepare(view, choice);
        gnoClusterReset(0, 1);
        eachTile(8, 8, [](uvec2, uint invocation, const GnoViewSample& s) { gnoClusterMeasureDepth(s, invocation); });
        for (uint i = 0; i <= gnoClusterSlices(state.tree); ++i) state.slices[i] = gnoClusterSliceAt(i);
        const bool compact = choice.form == GNO_CLUSTER_COMPACT;
        build(compact || choice.form == GNO_CLUSTER_IMPLICIT ? GNO_CLUSTER_MASKS_OF_NODES
                                                             : GNO_CLUSTER_MASKS_OF_NODES | GNO_CLUSTER_BOUNDS_OF_NODES);
        for (uint word = 0; compact && word < gnoClusterWordCount(state.tree); ++word) gnoClusterAllocate(word);
        if (compact) build(GNO_CLUSTER_BOUNDS_OF_NODES);
        for (uint i = 0; i < state.casters.size(); ++i) gnoClusterSetUpVolume(i, gnoFacing(state.light, state.casters[i]));
        gnoClusterFinishVolumes();
        gnoClusterExpand();
        if (choice.split > 0) gnoClusterFinish();
        std::vector<uint32_t> mask;
        for (uint i = 0; i < view.pixels.size(); ++i) {
            const GnoViewSample& s = state.samples[i];
            if (s.own > GNO_NO_CASTER)
                mask.push_back(s.own == GNO_BACKGROUND ? GNO_VISIBILITY_BACKGROUND : GNO_VISIBILITY_FACING_AWAY);
            else
                mask.push_back(gnoClusterAnswer(uvec2(i % view.width, i / view.width), s.position));
        }
        return mask;
    }

private:
    static void prepare(const test::CameraView& view, const cpu::ClusterChoice& choice) {
        state.tree = gnoClusterLayout({view.width, view.height}, choice.form);
        state.frame = std::bit_cast<GnoClusterFrame>(host::clusterFrame(view.frame.camera, view.width, view.height));
        state.frame.casterCount = uint(view.frame.triangles.size());
        state.frame.jobCapacity = choice.split > 0 ? choice.jobCapacity : 0;
        state.frame.boxCapacity = choice.boxCapacity;
        state.frame.split = choice.split;
        state.frame.extraPlanes = choice.extraPlanes;
        state.light = view.light;
        state.precision = choice.precision;
        const uint poison = 0xDEADBEEFu;
        const bool compact = choice.form == GNO_CLUSTER_COMPACT;
        const size_t boxes = compact ? choice.boxCapacity : choice.form == GNO_CLUSTER_IMPLICIT ? 0 : gnoClusterNodeCount(state.tree);
        state.slices.keep(gnoClusterSlices(state.tree) + 1, uintBitsToFloat(poison));
        for (auto* bounds : {&state.low, &state.high}) bounds->keep(3 * boxes, uintBitsToFloat(poison));
        state.masks.keep(gnoClusterWordCount(state.tree), poison);
        state.shade.keep(gnoClusterShadeWords(state.tree), poison);
        state.pointers.keep(compact ? gnoClusterWordCount(state.tree) : 0, uvec2(poison));
        state.jobs.keep(state.frame.jobCapacity, uvec2(poison));
        state.volumes.keep(7 * view.frame.triangles.size(), vec4(uintBitsToFloat(poison)));
        state.info.keep(view.frame.triangles.size(), uvec2(poison));
        state.casters.clear();
        for (const host::Triangle& t : view.frame.triangles) state.casters.push_back({t.a, t.b, t.c});
        state.samples.clear();
        for (const host::OracleSample& s : view.pixels) state.samples.push_back({s.position, s.own});
    }

    template <class Work>
    static void eachTile(uint width, uint height, const Work& work) {
        const uvec2 size = state.frame.size;
        for (uint y = 0; y < size.y; y += height)
            for (uint x = 0; x < size.x; x += width)
                WorkGroup::run(width * height, [&](uint i) {
                    const uvec2 pixel(x + i % width, y + i / width);
                    GnoViewSample s{vec3(0), GNO_BACKGROUND};
                    if (pixel.x < size.x && pixel.y < size.y) s = state.samples[size_t(pixel.y) * size.x + pixel.x];
                    work(uvec2(x / width, y / height), i, s);
                });
    }

    static void build(uint what) {
        eachTile(GNO_CLUSTER_TILE, gnoClusterTileHeight(state.tree),
                 [what](uvec2 tile, uint invocation, const GnoViewSample& s) { gnoClusterAddTile(tile, invocation, s, what); });
        for (uint depth = state.tree.levels - 1; depth > 0; --depth)
            for (uint key = 0; key < gnoClusterWordsAt(state.tree, depth); ++key) gnoClusterUp(depth, key, what);
    }
};

[[maybe_unused]] const bool kRegistered =
    (cpu::clusterVariants().push_back({GNO_CLUSTER_VARIANT, [] { return std::unique_ptr<cpu::ClusterFamily>(std::make_unique<Family>()); }}), true);

}  // namespace
}  // namespace gno
