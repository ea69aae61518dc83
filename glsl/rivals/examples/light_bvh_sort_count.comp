#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Each round of the sort, first: how often each digit occurs. One work group per tile.
#define GNO_SORT_RUNS GNO_SORT_PASS_COUNT
#include "light_bvh_sort.glsl"

void main() { gnoSortCount(gl_WorkGroupID.x, gl_LocalInvocationIndex); }
