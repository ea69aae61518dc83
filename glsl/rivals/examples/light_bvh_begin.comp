#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Step 2: one work group.
#include "light_bvh_frame.glsl"

void main() {
    uint references = gnoArrayPrefix(gnoLightBvhGroups(gnoPush.count), gl_LocalInvocationIndex);
    if (gl_LocalInvocationIndex == 0u) gnoLightBvhBegin(references);
}
