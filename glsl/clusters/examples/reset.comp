#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Dispatch 1 of a cluster hierarchy: any number of invocations.
layout(local_size_x = 64) in;
layout(constant_id = 20) const uint kForm = 1u;
#define GNO_CLUSTER_FORM kForm
#include "../bindings.glsl"
#include "../build.glsl"

void main() { gnoClusterReset(gl_GlobalInvocationID.x, gl_NumWorkGroups.x * 64u); }
