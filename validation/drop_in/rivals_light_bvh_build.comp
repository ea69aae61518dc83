#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#include "gnomon/core/bindings.glsl"
#define GNO_LIGHT_BVH_BUILDS 1
#include "gnomon/rivals/light_bvh_bindings.glsl"
#include "gnomon/rivals/light_bvh_build.glsl"
layout(local_size_x = 64) in;

void main() {
    uint at = gl_GlobalInvocationID.x;
    GnoLightBvhCaster c = gnoLightBvhCaster(push.light, GNO_LOAD_CASTER(at), 1);
    uint faces = gnoLightBvhFaces(push.light, GNO_LIGHT_BVH_GRID, c);
    gnoLightBvhCount(at, faces, gl_WorkGroupID.x, gl_LocalInvocationIndex);
    gnoLightBvhBegin(push.count);
    gnoLightBvhEmit(at, faces, c, gnoLightBvhFirst(faces, gl_WorkGroupID.x, gl_LocalInvocationIndex));
    gnoLightBvhLeaf(at);
    gnoLightBvhUp(push.seed, at);
    gnoLightBvhSplit(at);
    gnoLightBvhCollapse(push.seed, at);
}
