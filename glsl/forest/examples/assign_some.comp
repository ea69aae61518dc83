#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Steps 3, 4 and 6 for the casters with some cells: one invocation per caster.
layout(local_size_x = 64) in;
#include "../../core/permutation.glsl"
#include "frame.glsl"

void main() {
    uint count = gnoForestHeader.v.some;
    if (gl_GlobalInvocationID.x < count) assign(gnoList.v[gnoPermute(gl_GlobalInvocationID.x, count, gnoPush.seed)], 0u, 1u);
}
