#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Writes the references of each triangle, and their keys. One invocation per triangle.
#define GNO_LIGHT_BVH_BUILDS GNO_LIGHT_BVH_PASS_EMIT
#include "light_bvh_frame.glsl"
layout(set = 2, binding = 0, std430) readonly buffer GnoExampleStates { uint v[]; } gnoStates;

void main() {
    uint caster = gl_GlobalInvocationID.x;
    uint faces = caster < gnoPush.count ? gnoLightBvhMasks.v[caster] : 0u;
    uint first = gnoLightBvhFirst(faces, gl_WorkGroupID.x, gl_LocalInvocationIndex);
    if (faces == 0u) return;
    gnoLightBvhEmit(caster, faces, gnoLightBvhCaster(GNO_LIGHT, GNO_LOAD_CASTER(caster), gnoCasterFacing(gnoStates.v[caster])), first);
}
