#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Step 6: one invocation per box of the row, as many as the row has at most; the row stands where other passes have the seed.
#include "light_bvh_frame.glsl"

void main() { gnoLightBvhUp(gnoPush.seed, gl_GlobalInvocationID.x); }
