#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/caster_state.glsl with hull planes of our own.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/bindings.glsl"
layout(set = 2, binding = 4, std140) uniform Hull { vec4 plane[6]; } hull;
#define GNO_LOAD_CULL_PLANE(i) hull.plane[i]
#include "gnomon/core/caster_state.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    uint state = gnoCasterState(push.light, GNO_LOAD_CASTER(at), true, GNO_CULL_FRONT | GNO_CULL_HULL, 6u);
    result = vec4(float(gnoCasterFacing(state)), float(state & GNO_CASTER_KEPT), 0.0, 0.0);
    results.v[at] = result;
}
