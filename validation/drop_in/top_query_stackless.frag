#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#define GNO_TOP_READ_ONLY 1
#include "gnomon/core/bindings.glsl"
#include "gnomon/top/bindings.glsl"
#include "gnomon/top/query_stackless.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    result = vec4(gnoTopQueryStackless(GnoViewSample(push.position.xyz, at)));
}
