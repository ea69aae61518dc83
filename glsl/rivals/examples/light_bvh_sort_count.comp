#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Step 4, each round: one work group per tile.
#include "light_bvh_sort.glsl"

void main() { gnoSortCount(gl_WorkGroupID.x, gl_LocalInvocationIndex); }
