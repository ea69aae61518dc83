#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/transmittance_sum.glsl with our buffer.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_TRANSMITTANCE_ADDS 1
#include "gnomon/core/material_bindings.glsl"
#include "gnomon/core/transmittance_sum.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    if (!gnoIsDark(at)) gnoAddTransmittance(at, uvec3(push.count));
    if (push.seed == 1u) gnoAddOpaque(at);
    result = vec4(vec3(gnoTransmittanceSum(at)), 1.0);
    results.v[at] = result;
}
