#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_ray_query : require
// SPDX-License-Identifier: MIT
// Way B: our structure at another set and binding.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_RAY_QUERY_SET 2
#define GNO_RAY_QUERY_BINDING_STRUCTURE 5
#define GNO_LIGHT push.light
#include "gnomon/rivals/ray_query_bindings.glsl"
#include "gnomon/rivals/ray_query.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    result = vec4(gnoRayQueryInShadow(GnoViewSample(push.position.xyz, at)));
    results.v[at] = result;
}
