#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// rivals/ray_query_index.glsl needs nothing.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/rivals/ray_query_index.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    result = vec4(gnoRayQueryIndices(at, at == push.seed ? 0 : 1), 0.0);
}
