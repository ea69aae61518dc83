#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// rivals/ray_query_index.glsl needs nothing.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/rivals/ray_query_index.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    result = vec4(gnoRayQueryIndices(at, at == push.seed ? 0 : 1), 0.0);
    results.v[at] = result;
}
