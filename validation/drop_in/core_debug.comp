#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/debug.glsl: queries and insertions that look for what should not happen, with the default counter.
layout(push_constant) uniform Push { vec4 light; vec4 position; uint count; uint seed; } push;
#define GNO_DEBUG 1
#define GNO_LIGHT push.light
#include "gnomon/core/bindings.glsl"
#include "gnomon/core/debug.glsl"
#define GNO_TOP_BUILDS 1
#include "gnomon/top/bindings.glsl"
#include "gnomon/top/build.glsl"
#include "gnomon/top/query_hybrid.glsl"
#include "gnomon/top/query_stack.glsl"
#include "gnomon/top/query_stackless.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    bool inserted = gnoTopInsert(at);
    GnoViewSample s = GnoViewSample(push.position.xyz, at);
    uint answers = gnoTopHybridAnswer(s) + gnoTopStackAnswer(s) + gnoTopStacklessAnswer(s);
    result = vec4(inserted, float(answers), float(gnoDebugFaults.endless), float(gnoDebugFaults.outside));
    results.v[at] = result;
}
