#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#define GNO_SHADOW_MAP_MEASURES 1
#include "gnomon/shadow_map/bindings.glsl"
#include "gnomon/shadow_map/fit.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    gnoShadowMapMeasure(GnoViewSample(push.position.xyz, at));
    result = gnoShadowMapFit(uvec4(GNO_SHADOW_MAP_BOUNDS[0], GNO_SHADOW_MAP_BOUNDS[1], GNO_SHADOW_MAP_BOUNDS[2], GNO_SHADOW_MAP_BOUNDS[3]),
                             vec4(-1.0, 1.0, -1.0, 1.0));
}
