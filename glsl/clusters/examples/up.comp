#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// One invocation per node of one depth, from the last but one up to 1: a dispatch each.
layout(local_size_x = 64) in;
layout(constant_id = 20) const uint kForm = 1u;
#define GNO_CLUSTER_FORM kForm
layout(constant_id = 21) const uint kWhat = 3u;
#include "../bindings.glsl"
#include "../build.glsl"
layout(push_constant) uniform GnoExampleUp { uint depth; } gnoUp;

void main() {
    uint key = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u + gl_LocalInvocationID.x;
    if (key < gnoClusterWordsAt(GNO_CLUSTER_LAYOUT, gnoUp.depth)) gnoClusterUp(gnoUp.depth, key, kWhat);
}
