#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// After the sort: the box of each reference. One invocation per reference.
#define GNO_LIGHT_BVH_BUILDS GNO_LIGHT_BVH_PASS_LEAVES
#include "light_bvh_frame.glsl"

void main() { gnoLightBvhLeaf(gl_GlobalInvocationID.x); }
