#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Before the build of the bottom level: one invocation per caster copies its vertices, as NaN where the caster is left out.
#include "../../core/bindings.glsl"
#include "../../core/caster_state.glsl"
#include "../../core/examples/frame.glsl"
#include "../ray_query_vertex.glsl"
layout(local_size_x = 64) in;
layout(set = 2, binding = 0, std430) readonly buffer GnoExampleStates { uint v[]; } gnoStates;
layout(set = 2, binding = 1, std430) writeonly buffer GnoExampleVertices { uint v[]; } gnoRayVertices;  // 9 words per caster

void store(uint at, uvec3 bits) {
    gnoRayVertices.v[at] = bits.x;
    gnoRayVertices.v[at + 1u] = bits.y;
    gnoRayVertices.v[at + 2u] = bits.z;
}

void main() {
    uint caster = gl_GlobalInvocationID.x;
    if (caster >= gnoPush.count) return;
    GnoCaster t = GNO_LOAD_CASTER(caster);
    int facing = gnoCasterFacing(gnoStates.v[caster]);
    store(9u * caster, gnoRayQueryVertex(t.a, facing));
    store(9u * caster + 3u, gnoRayQueryVertex(t.b, facing));
    store(9u * caster + 6u, gnoRayQueryVertex(t.c, facing));
}
