#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Steps 4 and 6 for the casters with few cells. One invocation per caster.
layout(local_size_x = 64) in;
#include "../../core/permutation.glsl"
#include "frame.glsl"

void main() {
    if (gl_GlobalInvocationID.x >= gnoPush.count) return;
    if (kStep == 4u) gnoForestCountFew(gl_GlobalInvocationID.x);
    else gnoForestEmitFew(gnoPermute(gl_GlobalInvocationID.x, gnoPush.count, gnoPush.seed));  // so that each cell has its casters in random order
}
