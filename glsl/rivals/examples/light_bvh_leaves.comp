#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Step 5: one invocation per reference.
#include "light_bvh_frame.glsl"

void main() { gnoLightBvhLeaf(gl_GlobalInvocationID.x); }
