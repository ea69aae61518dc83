#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way B: our buffers, other sets and bindings; every option of the query at another value.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#define GNO_CORE_SET 2
#define GNO_CORE_BINDING_CASTERS 7
#define GNO_TOP_SET 2
#define GNO_TOP_BINDING_PLANES 5
#define GNO_TOP_BINDING_LINKS 6
#define GNO_TOP_BINDING_HEADER 9
#define GNO_TOP_BINDING_SLABS 10
#define GNO_TOP_BIND_SLABS 1
#define GNO_TOP_SLAB 1
#define GNO_TOP_DEPTH_TEST 0
#define GNO_PRECISION GNO_PRECISION_CONSERVATIVE
#include "gnomon/core/bindings.glsl"
#include "gnomon/top/bindings.glsl"
#include "gnomon/top/query_stackless.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    result = vec4(gnoTopQueryStackless(GnoViewSample(push.position.xyz, at)));
    results.v[at] = result;
}
