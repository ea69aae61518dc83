#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#include "gnomon/shadow_map/bindings.glsl"
#include "gnomon/shadow_map/map_bindings.glsl"
#include "gnomon/shadow_map/query.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    result = vec4(gnoShadowMapQuery(GnoViewSample(push.position.xyz, at)));
}
