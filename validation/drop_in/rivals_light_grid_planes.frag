#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// No buffer needed.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/rivals/light_grid_planes.glsl"
layout(location = 0) out vec4 colour;

void main() {
    uint at = uint(gl_FragCoord.x);
    vec4 result;
    GnoCaster t = GnoCaster(push.position.xyz, push.viewer.xyz, push.position.zyx);
    result = gnoLightGridPlane(push.light, t, 1, at & 3u);
    result.w = gnoLightGridSide(push.light, result, push.viewer.xyz) + gnoLightGridReach(push.light, result);
    colour = result;
}
