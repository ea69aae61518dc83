#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Each pair goes into its cell's tree. One invocation per pair, in random order.
#include "../../core/constant_ids.h"
layout(local_size_x = 64) in;
layout(constant_id = GNO_ID_PRECISION) const uint kPrecision = 2u;
layout(constant_id = GNO_ID_SLAB) const uint kSlab = 0u;
layout(constant_id = GNO_ID_STORE_PLANES) const uint kStorePlanes = 1u;
#define GNO_PRECISION kPrecision
#define GNO_TOP_BIND_SLABS 1
#define GNO_TOP_SLAB kSlab
#define GNO_TOP_STORE_PLANES kStorePlanes
#include "../../core/bindings.glsl"
#include "../../core/examples/frame.glsl"
#include "../../core/permutation.glsl"
#define GNO_FOREST_TREES 1
#define GNO_FOREST_BUILDS GNO_FOREST_PASS_BUILD
#define GNO_TOP_BUILDS GNO_TOP_PASS_BUILD
#include "../bindings.glsl"
#include "../../top/bindings.glsl"
#include "../../top/build.glsl"
#if GNO_COUNTERS
layout(set = 2, binding = 5, std430) buffer GnoExampleTotals { uint v[]; } gnoTotals;  // steps (low, high word), intersections, dropped, inserted
#endif

void main() {
    if (gl_GlobalInvocationID.x >= GNO_TOP_HEADER.casterCount) return;  // pairs; none when some are missing
    bool inserted = gnoTopInsert(gl_GlobalInvocationID.x);
#if GNO_COUNTERS
    uint before = atomicAdd(gnoTotals.v[0], gnoCounters.buildSteps);
    if (before + gnoCounters.buildSteps < before) atomicAdd(gnoTotals.v[1], 1u);
    atomicAdd(gnoTotals.v[2], gnoCounters.intersections);
    atomicAdd(gnoTotals.v[3], gnoCounters.dropped);
    atomicAdd(gnoTotals.v[4], inserted ? 1u : 0u);
#endif
}
