#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// One invocation per triangle: facing and culling.
#include "../bindings.glsl"
#include "frame.glsl"
layout(local_size_x = 64) in;
layout(set = 2, binding = 10, std430) readonly buffer GnoExampleClosed { uint v[]; } gnoClosed;  // one bit per triangle
layout(set = 2, binding = 0, std430) writeonly buffer GnoExampleStates { uint v[]; } gnoStates;
layout(set = 2, binding = 11, std140) uniform GnoExamplePlanes { vec4 v[16]; } gnoCullPlanes;
#define GNO_LOAD_CULL_PLANE(index_) gnoCullPlanes.v[index_]
#include "../caster_state.glsl"

void main() {
    uint caster = gl_GlobalInvocationID.x;
    if (caster >= gnoPush.count) return;
    bool closed = ((gnoClosed.v[caster >> 5] >> (caster & 31u)) & 1u) != 0u;
    gnoStates.v[caster] = gnoCasterState(gnoPush.light, GNO_LOAD_CASTER(caster), closed, gnoPush.cull, gnoPush.planes);
}
