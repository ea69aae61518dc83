#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/decide.glsl on the two rungs that have a last word.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/bindings.glsl"
#include "gnomon/core/decide.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    bool exact = gnoDecideInShadow(push.light, GNO_LOAD_CASTER(at), push.position.xyz, GNO_PRECISION_CERTIFIED);
    bool fp32 = gnoDecideInShadow(push.light, GNO_LOAD_CASTER(at), push.position.xyz, GNO_PRECISION_CONSERVATIVE);
    result = vec4(exact, fp32, 0.0, 0.0);
}
