#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Dispatch 1 of a cluster hierarchy: any number of invocations.
#include "../../core/constant_ids.h"
layout(local_size_x = 64) in;
layout(constant_id = GNO_ID_FORM) const uint kForm = 1u;
#define GNO_CLUSTER_FORM kForm
#define GNO_CLUSTER_BUILDS GNO_CLUSTER_PASS_RESET
#include "../bindings.glsl"
#include "../build.glsl"

void main() { gnoClusterReset(gl_GlobalInvocationID.x, gl_NumWorkGroups.x * 64u); }
