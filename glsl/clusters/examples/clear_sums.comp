#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Where some casters let light through: one invocation per pixel, before the traversal.
layout(local_size_x = 8, local_size_y = 8) in;
#include "../bindings.glsl"
#define GNO_MATERIAL_SET 3
#define GNO_TRANSMITTANCE_ADDS 1
#include "../../core/material_bindings.glsl"

void main() {
    if (any(greaterThanEqual(gl_GlobalInvocationID.xy, GNO_CLUSTER_FRAME.size))) return;
    uint at = 4u * (gl_GlobalInvocationID.y * GNO_CLUSTER_FRAME.size.x + gl_GlobalInvocationID.x);
    for (uint i = 0u; i < 4u; ++i) GNO_TRANSMITTANCE_SUMS[at + i] = 0u;
}
