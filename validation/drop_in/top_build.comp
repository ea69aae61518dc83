#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#include "gnomon/core/bindings.glsl"
#define GNO_TOP_BUILDS 1
#include "gnomon/top/bindings.glsl"
#include "gnomon/top/build.glsl"
#include "gnomon/core/orient3d.glsl"
#include "gnomon/core/permutation.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    if (at == 0u) gnoTopBegin(push.count, gnoState(GNO_PRECISION));
    gnoTopSetUp(at, gnoFacing(push.light, GNO_LOAD_CASTER(at)));
    result = vec4(gnoTopInsert(gnoPermute(at, push.count, push.seed)));
    results.v[at] = result;
}
