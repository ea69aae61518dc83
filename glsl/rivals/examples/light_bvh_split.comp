#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Where the range of each inner node splits. One invocation per reference.
#define GNO_LIGHT_BVH_BUILDS GNO_LIGHT_BVH_PASS_SPLIT
#include "light_bvh_frame.glsl"

void main() { gnoLightBvhSplit(gl_GlobalInvocationID.x); }
