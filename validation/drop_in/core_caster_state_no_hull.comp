#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/caster_state.glsl without GNO_LOAD_CULL_PLANE: no hull culling, and nothing to define.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/bindings.glsl"
#include "gnomon/core/caster_state.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    result = vec4(float(gnoCasterFacing(gnoCasterState(push.light, GNO_LOAD_CASTER(at), false, 0u, 0u))));
    results.v[at] = result;
}
