#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: queries over the trees of a forest, our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#define GNO_FOREST_TREES 1
#include "gnomon/core/bindings.glsl"
#include "gnomon/forest/bindings.glsl"
#include "gnomon/top/bindings.glsl"
#include "gnomon/top/query_hybrid.glsl"
#include "gnomon/top/query_stack.glsl"
#include "gnomon/top/query_stackless.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    GnoViewSample s = GnoViewSample(push.position.xyz, at);
    results.v[at] = vec4(gnoTopQueryStack(s), gnoTopQueryStackless(s), gnoTopQueryHybrid(s), 1.0);
}
