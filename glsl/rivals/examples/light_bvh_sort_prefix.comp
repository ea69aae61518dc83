#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Step 4, each round, then: one work group.
#include "light_bvh_sort.glsl"

void main() { gnoArrayPrefix(gnoSortCounts(GNO_SORT_LENGTH), gl_LocalInvocationIndex); }
