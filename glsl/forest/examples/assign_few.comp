#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Casters with few cells: counts them, and in a second dispatch (kStep) puts them into the pool. One invocation per caster.
layout(local_size_x = 64) in;
#include "../../core/permutation.glsl"
#define GNO_FOREST_BUILDS (GNO_FOREST_PASS_COUNT | GNO_FOREST_PASS_EMIT)
#include "frame.glsl"

void main() {
    if (gl_GlobalInvocationID.x >= gnoPush.count) return;
    if (kStep == 4u) gnoForestCountFew(gl_GlobalInvocationID.x);
    else gnoForestEmitFew(gnoPermute(gl_GlobalInvocationID.x, gnoPush.count, gnoPush.seed));  // so that each cell has its casters in random order
}
