#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/caster_state.glsl with hull planes of our own.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/bindings.glsl"
layout(set = 2, binding = 4, std140) uniform Hull { vec4 plane[6]; } hull;
#define GNO_LOAD_CULL_PLANE(i) hull.plane[i]
#include "gnomon/core/caster_state.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    uint state = gnoCasterState(push.light, GNO_LOAD_CASTER(at), true, GNO_CULL_FRONT | GNO_CULL_HULL, 6u);
    result = vec4(float(gnoCasterFacing(state)), float(state & GNO_CASTER_KEPT), 0.0, 0.0);
}
