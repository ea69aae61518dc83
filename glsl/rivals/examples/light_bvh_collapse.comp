#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Opens the nodes of one level to four children: one invocation per node of the level; gnoPush.number is the level.
#define GNO_LIGHT_BVH_BUILDS GNO_LIGHT_BVH_PASS_COLLAPSE
#include "light_bvh_frame.glsl"

void main() { gnoLightBvhCollapse(gnoPush.number, gl_GlobalInvocationID.x); }
