#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/caster_state.glsl without GNO_LOAD_CULL_PLANE: no hull culling, and nothing to define.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/bindings.glsl"
#include "gnomon/core/caster_state.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    result = vec4(float(gnoCasterFacing(gnoCasterState(push.light, GNO_LOAD_CASTER(at), false, 0u, 0u))));
}
