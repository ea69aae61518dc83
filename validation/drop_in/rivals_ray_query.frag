#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_ray_query : require
// SPDX-License-Identifier: MIT
// Way A: our structure, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#include "gnomon/rivals/ray_query_bindings.glsl"
#include "gnomon/rivals/ray_query.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    result = vec4(gnoRayQueryInShadow(GnoViewSample(push.position.xyz, at)));
}
