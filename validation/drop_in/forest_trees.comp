#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: the trees of a forest, our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#define GNO_FOREST_TREES 1
#include "gnomon/core/bindings.glsl"
#define GNO_FOREST_BUILDS GNO_FOREST_PASS_BUILD
#include "gnomon/forest/bindings.glsl"
#define GNO_TOP_BUILDS 1
#include "gnomon/top/bindings.glsl"
#include "gnomon/top/build.glsl"
#include "gnomon/top/query_hybrid.glsl"
#include "gnomon/top/query_stack.glsl"
#include "gnomon/top/query_stackless.glsl"
layout(local_size_x = 64) in;
layout(set = 2, binding = 9, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    gnoTopSetUp(at, gnoFacing(push.light, GNO_LOAD_CASTER(GNO_TOP_CASTER_OF(at))));
    bool inserted = gnoTopInsert(at);
    GnoViewSample s = GnoViewSample(push.position.xyz, at);
    results.v[at] = vec4(inserted, gnoTopQueryStack(s), gnoTopQueryStackless(s), gnoTopQueryHybrid(s));
}
