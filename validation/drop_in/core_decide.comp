#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/decide.glsl on the two rungs that have a last word.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/bindings.glsl"
#include "gnomon/core/decide.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    bool exact = gnoDecideInShadow(push.light, GNO_LOAD_CASTER(at), push.position.xyz, GNO_PRECISION_CERTIFIED);
    bool fp32 = gnoDecideInShadow(push.light, GNO_LOAD_CASTER(at), push.position.xyz, GNO_PRECISION_CONSERVATIVE);
    result = vec4(exact, fp32, 0.0, 0.0);
    results.v[at] = result;
}
