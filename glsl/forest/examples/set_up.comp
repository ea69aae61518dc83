#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Planes, where they are kept, and empty links of each pair. One invocation per pair.
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
#include "../../core/caster_state.glsl"
#include "../../core/examples/frame.glsl"
#define GNO_FOREST_TREES 1
#define GNO_TOP_BUILDS GNO_TOP_PASS_SET_UP
#include "../bindings.glsl"
#include "../../top/bindings.glsl"
#include "../../top/build.glsl"
layout(set = 2, binding = 0, std430) readonly buffer GnoExampleStates { uint v[]; } gnoStates;

void main() {
    uint block = gl_GlobalInvocationID.x;
    uint state = gnoForestState(gnoForestHeader.v, GNO_FOREST_CAPACITY, GNO_PRECISION);
    uint count = state == gnoState(GNO_PRECISION) ? gnoForestHeader.v.pairs : 0u;
    if (block == 0u) gnoTopBegin(count, state);
    if (block < count) gnoTopSetUp(block, gnoCasterFacing(gnoStates.v[GNO_TOP_CASTER_OF(block)]));
}
