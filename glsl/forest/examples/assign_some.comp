#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Casters with some cells: a dispatch each (kStep) covers cells, counts pairs, and puts them into the pool. One invocation per caster.
layout(local_size_x = 64) in;
#include "../../core/permutation.glsl"
#include "assign.glsl"

void main() {
    uint count = gnoForestHeader.v.some;
    if (gl_GlobalInvocationID.x < count) assign(gnoList.v[gnoPermute(gl_GlobalInvocationID.x, count, gnoPush.seed)], 0u, 1u);
}
