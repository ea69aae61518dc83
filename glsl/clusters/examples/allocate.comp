#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Compact bounds: one invocation per word of the tree.
#include "../../core/constant_ids.h"
layout(local_size_x = 64) in;
layout(constant_id = GNO_ID_FORM) const uint kForm = 1u;
#define GNO_CLUSTER_FORM kForm
#define GNO_CLUSTER_BUILDS GNO_CLUSTER_PASS_ALLOCATE
#include "../bindings.glsl"
#include "../build.glsl"

void main() {
    uint word = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u + gl_LocalInvocationID.x;
    if (word < gnoClusterWordCount(GNO_CLUSTER_LAYOUT)) gnoClusterAllocate(word);
}
