#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way C: sums between other things of the user's own.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
layout(set = 1, binding = 8, std430) buffer Frame { vec4 colour[64]; uint sums[]; } frame;
#define GNO_TRANSMITTANCE_SUMS frame.sums
#include "gnomon/core/transmittance_sum.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    if (!gnoIsDark(at)) gnoAddTransmittance(at, uvec3(push.count));
    if (push.seed == 1u) gnoAddOpaque(at);
    results.v[at] = vec4(vec3(gnoTransmittanceSum(at)), 1.0);
}
