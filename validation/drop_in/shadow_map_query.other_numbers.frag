#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way B: our buffers, other sets and bindings.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_SHADOW_MAP_SET 2
#define GNO_SHADOW_MAP_BINDING_VIEWS 20
#define GNO_SHADOW_MAP_BINDING_BOUNDS 21
#define GNO_SHADOW_MAP_BINDING_MAP 22
#define GNO_LIGHT push.light
#include "gnomon/shadow_map/bindings.glsl"
#include "gnomon/shadow_map/map_bindings.glsl"
#include "gnomon/shadow_map/query.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    result = vec4(gnoShadowMapQuery(GnoViewSample(push.position.xyz, at)));
}
