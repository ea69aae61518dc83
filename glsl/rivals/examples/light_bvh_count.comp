#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// How many references each triangle has. One invocation per triangle.
#define GNO_LIGHT_BVH_BUILDS GNO_LIGHT_BVH_PASS_COUNT
#include "light_bvh_frame.glsl"
layout(set = 2, binding = 0, std430) readonly buffer GnoExampleStates { uint v[]; } gnoStates;

void main() {
    uint caster = gl_GlobalInvocationID.x;
    uint faces = 0u;
    int facing = caster < gnoPush.count ? gnoCasterFacing(gnoStates.v[caster]) : 0;
    if (facing != 0) faces = gnoLightBvhFaces(GNO_LIGHT, GNO_LIGHT_BVH_GRID, gnoLightBvhCaster(GNO_LIGHT, GNO_LOAD_CASTER(caster), facing));
    gnoLightBvhCount(caster, faces, gl_WorkGroupID.x, gl_LocalInvocationIndex);
}
