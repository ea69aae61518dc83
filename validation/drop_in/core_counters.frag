#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/counters.glsl, compiled with GNO_COUNTERS 0 and 1.
#include "gnomon/core/counters.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    GNO_COUNT(visitedNodes, at);
    GNO_COUNT_MAX(deepestStack, at);
    result = vec4(0.0);
#if GNO_COUNTERS
    result = vec4(float(gnoCounters.visitedNodes), float(gnoCounters.deepestStack), 0.0, 0.0);
#endif
}
