#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Casters with many cells: a dispatch each (kStep) covers cells, counts pairs, and puts them into the pool. One work group per caster.
layout(local_size_x = 64) in;
#include "assign.glsl"

void main() {
    for (uint n = gl_WorkGroupID.x; n < gnoForestHeader.v.many; n += gl_NumWorkGroups.x)
        assign(gnoList.v[gnoPush.count - 1u - n], gl_LocalInvocationIndex, 64u);
}
