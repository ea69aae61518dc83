#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Dispatch 3: where each depth slice begins.
#include "../../core/constant_ids.h"
layout(local_size_x = 64) in;
layout(constant_id = GNO_ID_FORM) const uint kForm = 1u;
#define GNO_CLUSTER_FORM kForm
#define GNO_CLUSTER_BUILDS GNO_CLUSTER_PASS_SLICES
#include "../bindings.glsl"
#include "../build.glsl"

void main() {
    uint slice = gl_GlobalInvocationID.x;
    if (slice <= gnoClusterSlices(GNO_CLUSTER_LAYOUT)) GNO_CLUSTER_SLICES[slice] = gnoClusterSliceAt(slice);
}
