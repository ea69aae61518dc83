#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/light.glsl alone.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/light.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    vec3 q = gnoFromLight(push.light, push.position.xyz);
    result = vec4(gnoLightScale(push.light, q), gnoLightDepth(push.light, q), float(at), GNO_ULP);
    results.v[at] = result;
}
