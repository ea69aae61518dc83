#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Each round of the sort, then: where each digit of each tile goes. One work group.
#define GNO_SORT_RUNS 0
#include "light_bvh_sort.glsl"

void main() { gnoArrayPrefix(gnoSortCounts(GNO_SORT_LENGTH), gl_LocalInvocationIndex); }
