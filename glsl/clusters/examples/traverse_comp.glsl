// SPDX-License-Identifier: MIT
// main() of the traversal, with and without casters that let light through (GNO_CLUSTER_LAYERS).
// kPass 1 expands, 2 finishes what the first left. Any number of work groups.
#include "../../core/constant_ids.h"
layout(local_size_x = 32) in;
layout(constant_id = GNO_ID_PRECISION) const uint kPrecision = 2u;
#define GNO_PRECISION kPrecision
layout(constant_id = GNO_ID_FORM) const uint kForm = 1u;
#define GNO_CLUSTER_FORM kForm
layout(constant_id = GNO_ID_PASS) const uint kPass = 1u;
#include "../../core/bindings.glsl"
#include "../../core/sample.glsl"
#include "../../core/examples/frame.glsl"
#define GNO_CLUSTER_BUILDS (GNO_CLUSTER_PASS_EXPAND | GNO_CLUSTER_PASS_FINISH)
#include "../bindings.glsl"
layout(set = 2, binding = 2, rgba32ui) uniform readonly uimage2D gnoSamples;
#define GNO_CLUSTER_LOAD_SAMPLE(pixel_) gnoUnpackViewSample(imageLoad(gnoSamples, pixel_))
#if GNO_COUNTERS
layout(set = 2, binding = 4, r32ui) uniform uimage2D gnoCounts;                    // samples tested, per pixel
layout(set = 2, binding = 5, std430) buffer GnoExampleTotals { uint v[]; } gnoTotals;  // pairs of low and high word, see main()
layout(set = 2, binding = 6, std430) buffer GnoExampleSteps { uint v[]; } gnoSteps;    // iterations of every job of this pass
#define GNO_CLUSTER_ON_LEAF_TEST(pixel_) imageAtomicAdd(gnoCounts, ivec2(pixel_), 1u)
#define GNO_CLUSTER_ON_JOB(job_) if (subgroupElect()) gnoSteps.v[job_] = gnoClusterSteps
#endif
#if GNO_CLUSTER_LAYERS
#define GNO_MATERIAL_SET 3
#define GNO_TRANSMITTANCE_ADDS 1
#include "../../core/material_bindings.glsl"
#include "../../core/transmittance.glsl"
#include "../../core/transmittance_sum.glsl"
bool gnoExampleLayer(uint caster, GnoCaster t, uvec2 pixel, vec3 p) {
    uvec3 taken = gnoTransmittance(caster, t, gnoPush.light, p);
    if (all(equal(taken, uvec3(GNO_TRANSMITTANCE_OPAQUE)))) return true;
    gnoAddTransmittance(pixel.y * GNO_CLUSTER_FRAME.size.x + pixel.x, taken);
    return false;
}
#define GNO_CLUSTER_IS_OPAQUE(caster_) gnoIsOpaqueCaster(caster_)
#define GNO_CLUSTER_LAYER(caster_, t_, pixel_, p_) gnoExampleLayer(caster_, t_, pixel_, p_)
#endif
#include "../traverse.glsl"

#if GNO_COUNTERS
void add(uint at, uint amount) {
    uint before = atomicAdd(gnoTotals.v[2u * at], amount);
    if (before + amount < before) atomicAdd(gnoTotals.v[2u * at + 1u], 1u);
}
#endif

void main() {
    if (kPass == 1u) gnoClusterExpand();
    else gnoClusterFinish();
#if GNO_COUNTERS
    add(0u, gnoCounters.nodeTests);
    add(1u, gnoCounters.planeTests);
    add(2u, gnoCounters.leafTests);
    add(3u, gnoCounters.exactCalls);
    add(4u, gnoCounters.accepted);
#endif
}
