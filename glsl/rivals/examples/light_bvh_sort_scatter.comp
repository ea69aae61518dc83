#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Each round of the sort, last: every pair goes to its place. One work group per tile.
#define GNO_SORT_RUNS GNO_SORT_PASS_SCATTER
#include "light_bvh_sort.glsl"

void main() { gnoSortScatter(gl_WorkGroupID.x, gl_LocalInvocationIndex); }
