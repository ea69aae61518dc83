#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/permutation.glsl alone.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/permutation.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    result = vec4(float(gnoPermute(at, push.count, push.seed)));
}
