#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// One invocation per node of one depth (gnoPush.number), from the last but one up to 1: a dispatch each.
#include "../../core/constant_ids.h"
layout(local_size_x = 64) in;
layout(constant_id = GNO_ID_FORM) const uint kForm = 1u;
#define GNO_CLUSTER_FORM kForm
layout(constant_id = GNO_ID_WHAT) const uint kWhat = 3u;
#define GNO_CLUSTER_BUILDS GNO_CLUSTER_PASS_UP
#include "../../core/examples/frame.glsl"
#include "../bindings.glsl"
#include "../build.glsl"

void main() {
    uint key = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u + gl_LocalInvocationID.x;
    if (key < gnoClusterWordsAt(GNO_CLUSTER_LAYOUT, gnoPush.number)) gnoClusterUp(gnoPush.number, key, kWhat);
}
