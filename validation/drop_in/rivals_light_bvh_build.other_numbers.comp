#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way B: our buffers, another set and other bindings.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT_BVH_SET 2
#define GNO_LIGHT_BVH_BINDING_GRID 20
#define GNO_LIGHT_BVH_BINDING_HEADER 21
#define GNO_LIGHT_BVH_BINDING_NODES 22
#define GNO_LIGHT_BVH_BINDING_PARENTS 23
#define GNO_LIGHT_BVH_BINDING_MASKS 24
#define GNO_LIGHT_BVH_BINDING_SUMS 25
#define GNO_LIGHT_BVH_BINDING_LEVELS 26
#define GNO_LIGHT_BVH_BINDING_REFERENCES 27
#define GNO_LIGHT_BVH_BINDING_KEYS 28
#define GNO_LIGHT_BVH_BINDING_ORDER 29
#define GNO_LIGHT_BVH_BINDING_BOXES 30
#define GNO_LIGHT_BVH_BINDING_SPLITS 31
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
