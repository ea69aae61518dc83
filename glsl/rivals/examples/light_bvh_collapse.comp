#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Step 8: one invocation per node of the level; the level stands where other passes have the seed.
#include "light_bvh_frame.glsl"

void main() { gnoLightBvhCollapse(gnoPush.seed, gl_GlobalInvocationID.x); }
