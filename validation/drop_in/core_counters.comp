#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/counters.glsl, compiled with GNO_COUNTERS 0 and 1.
#include "gnomon/core/counters.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    GNO_COUNT(visitedNodes, at);
    GNO_COUNT_MAX(deepestStack, at);
    result = vec4(0.0);
#if GNO_COUNTERS
    result = vec4(float(gnoCounters.visitedNodes), float(gnoCounters.deepestStack), 0.0, 0.0);
#endif
    results.v[at] = result;
}
