#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#include "gnomon/core/bindings.glsl"
#include "gnomon/forest/bindings.glsl"
#define GNO_LIGHT_GRID_READ_ONLY 1
#include "gnomon/rivals/light_grid_bindings.glsl"
#include "gnomon/rivals/light_grid_query.glsl"
layout(location = 0) out vec4 colour;

void main() {
    uint at = uint(gl_FragCoord.x);
    vec4 result;
    result = vec4(gnoLightGridQuery(GnoViewSample(push.position.xyz, at)));
    colour = result;
}
