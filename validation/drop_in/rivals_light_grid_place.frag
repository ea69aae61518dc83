#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// No buffer needed.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/rivals/light_grid_place.glsl"
layout(location = 0) out vec4 colour;

void main() {
    uint at = uint(gl_FragCoord.x);
    vec4 result;
    GnoForestGrid grid = gnoLightGridFine(GnoForestGrid(vec4(-1.0), vec4(-1.0), 0.25, 0.25, 8u, 6u));
    result = vec4(gnoLightGridPlace(push.light, grid, push.position.xyz), gnoLightGridAt(grid, at).xy);
    colour = result;
}
