#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/light.glsl alone.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/light.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    vec3 q = gnoFromLight(push.light, push.position.xyz);
    result = vec4(gnoLightScale(push.light, q), gnoLightDepth(push.light, q), float(at), GNO_ULP);
}
