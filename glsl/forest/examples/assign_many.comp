#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Steps 3, 4 and 6 for the casters with many cells: one work group per caster.
layout(local_size_x = 64) in;
#include "frame.glsl"

void main() {
    for (uint n = gl_WorkGroupID.x; n < gnoForestHeader.v.many; n += gl_NumWorkGroups.x)
        assign(gnoList.v[gnoPush.count - 1u - n], gl_LocalInvocationIndex, 64u);
}
