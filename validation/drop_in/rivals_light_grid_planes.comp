#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// No buffer needed.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/rivals/light_grid_planes.glsl"
layout(local_size_x = 64) in;
layout(set = 2, binding = 9, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    GnoCaster t = GnoCaster(push.position.xyz, push.viewer.xyz, push.position.zyx);
    result = gnoLightGridPlane(push.light, t, 1, at & 3u);
    result.w = gnoLightGridSide(push.light, result, push.viewer.xyz) + gnoLightGridReach(push.light, result);
    results.v[at] = result;
}
