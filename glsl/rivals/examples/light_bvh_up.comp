#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Boxes of one row from those of the row below: one invocation per box of the row, as many as the row has at most; gnoPush.number is the row.
#define GNO_LIGHT_BVH_BUILDS GNO_LIGHT_BVH_PASS_UP
#include "light_bvh_frame.glsl"

void main() { gnoLightBvhUp(gnoPush.number, gl_GlobalInvocationID.x); }
