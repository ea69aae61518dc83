#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: queries over the trees of a forest, our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#define GNO_FOREST_TREES 1
#define GNO_TOP_READ_ONLY 1
#include "gnomon/core/bindings.glsl"
#include "gnomon/forest/bindings.glsl"
#include "gnomon/top/bindings.glsl"
#include "gnomon/top/query_hybrid.glsl"
#include "gnomon/top/query_stack.glsl"
#include "gnomon/top/query_stackless.glsl"
layout(location = 0) out vec4 result;

void main() {
    GnoViewSample s = GnoViewSample(push.position.xyz, uint(gl_FragCoord.x));
    result = vec4(gnoTopQueryStack(s), gnoTopQueryStackless(s), gnoTopQueryHybrid(s), 1.0);
}
