#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Dispatch 2 of a TOP tree: one invocation per caster, in random order.
#include "../../core/constant_ids.h"
layout(local_size_x = 64, local_size_x_id = GNO_ID_GROUP_SIZE) in;
layout(constant_id = GNO_ID_PRECISION) const uint kPrecision = 2u;
#define GNO_PRECISION kPrecision
#include "../../core/bindings.glsl"
#include "../../core/examples/frame.glsl"
#include "../../core/permutation.glsl"
#define GNO_TOP_BUILDS GNO_TOP_PASS_BUILD
#include "../bindings.glsl"
#include "../build.glsl"
#if GNO_COUNTERS
layout(set = 2, binding = 5, std430) buffer GnoExampleTotals { uint v[]; } gnoTotals;  // steps (low, high word), intersections, dropped, inserted
#endif

void main() {
    if (gl_GlobalInvocationID.x >= gnoPush.count) return;
    bool inserted = gnoTopInsert(gnoPermute(gl_GlobalInvocationID.x, gnoPush.count, gnoPush.seed));
#if GNO_COUNTERS
    uint before = atomicAdd(gnoTotals.v[0], gnoCounters.buildSteps);
    if (before + gnoCounters.buildSteps < before) atomicAdd(gnoTotals.v[1], 1u);
    atomicAdd(gnoTotals.v[2], gnoCounters.intersections);
    atomicAdd(gnoTotals.v[3], gnoCounters.dropped);
    atomicAdd(gnoTotals.v[4], inserted ? 1u : 0u);
#endif
}
