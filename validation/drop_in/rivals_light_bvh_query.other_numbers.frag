#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way B: our buffers, other sets and bindings, a short stack, another precision.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#define GNO_CORE_SET 1
#define GNO_CORE_BINDING_CASTERS 7
#define GNO_LIGHT_BVH_SET 0
#define GNO_LIGHT_BVH_BINDING_GRID 20
#define GNO_LIGHT_BVH_BINDING_HEADER 21
#define GNO_LIGHT_BVH_BINDING_NODES 22
#define GNO_LIGHT_BVH_BINDING_PARENTS 23
#define GNO_LIGHT_BVH_STACK_SIZE 5
#define GNO_PRECISION GNO_PRECISION_CONSERVATIVE
#include "gnomon/core/bindings.glsl"
#include "gnomon/rivals/light_bvh_bindings.glsl"
#include "gnomon/rivals/light_bvh_query.glsl"
layout(location = 0) out vec4 result;

void main() {
    GnoViewSample s = GnoViewSample(push.position.xyz, push.seed);
    result = vec4(gnoLightBvhQuery(s) ? 1.0 : 0.0, gnoLightBvhQueryStackless(s) ? 1.0 : 0.0, 0.0, 0.0);
}
