#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#include "gnomon/core/bindings.glsl"
#define GNO_FOREST_BUILDS 1
#include "gnomon/forest/bindings.glsl"
#include "gnomon/forest/assign.glsl"
layout(local_size_x = 64) in;
layout(set = 2, binding = 9, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    GnoCellVolume volume = gnoCellVolume(GNO_LIGHT, GNO_LOAD_CASTER(at), 1);
    GnoForestSeen seen = gnoForestSeen();
    gnoForestSeeSample(seen, push.position.xyz);
    gnoForestTell(seen);
    gnoForestNone(at);
    uint size = gnoForestSort(at, gnoCellSight(GNO_LIGHT, GNO_LOAD_CASTER(at)));
    gnoForestCover(volume, 0u, 1u);
    gnoForestCountFew(at);
    gnoForestCount(volume, 0u, 1u);
    gnoForestAllocate(at);
    gnoForestEmitFew(at);
    gnoForestEmit(at, volume, 0u, 1u);
    gnoForestSizes();
    result = vec4(size);
    results.v[at] = result;
}
