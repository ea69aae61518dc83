#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// After the counts: their prefix sums, and an empty tree. One work group.
#define GNO_LIGHT_BVH_BUILDS GNO_LIGHT_BVH_PASS_BEGIN
#define GNO_PREFIX_WORDS gnoLightBvhSums.v
#include "light_bvh_frame.glsl"

void main() {
    uint references = gnoArrayPrefix(gnoLightBvhGroups(gnoPush.count), gl_LocalInvocationIndex);
    if (gl_LocalInvocationIndex == 0u) gnoLightBvhBegin(references);
}
