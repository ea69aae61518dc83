#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Before the build of the bottom level: one invocation per caster.
#include "../../core/caster_state.glsl"
#include "../../core/examples/frame.glsl"
#include "../ray_query_index.glsl"
layout(local_size_x = 64) in;
layout(set = 2, binding = 0, std430) readonly buffer GnoExampleStates { uint v[]; } gnoStates;
layout(set = 2, binding = 7, std430) writeonly buffer GnoExampleIndices { uint v[]; } gnoRayIndices;  // 3 words per caster

void main() {
    uint caster = gl_GlobalInvocationID.x;
    if (caster >= gnoPush.count) return;
    uvec3 indices = gnoRayQueryIndices(caster, gnoCasterFacing(gnoStates.v[caster]));
    for (uint i = 0u; i < 3u; ++i) gnoRayIndices.v[3u * caster + i] = indices[i];
}
