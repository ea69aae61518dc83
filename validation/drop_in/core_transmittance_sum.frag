#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/transmittance_sum.glsl with our buffer.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/material_bindings.glsl"
#include "gnomon/core/transmittance_sum.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    if (!gnoIsDark(at)) gnoAddTransmittance(at, uvec3(push.count));
    if (push.seed == 1u) gnoAddOpaque(at);
    result = vec4(vec3(gnoTransmittanceSum(at)), 1.0);
}
