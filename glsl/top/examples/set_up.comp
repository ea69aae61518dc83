#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Dispatch 1 of a TOP tree: one invocation per caster.
layout(local_size_x_id = 10) in;
layout(constant_id = 0) const uint kPrecision = 2u;
#define GNO_PRECISION kPrecision
#include "../../core/bindings.glsl"
#include "../../core/caster_state.glsl"
#include "../../core/examples/frame.glsl"
#include "../bindings.glsl"
#include "../build.glsl"
layout(set = 2, binding = 0, std430) readonly buffer GnoExampleStates { uint v[]; } gnoStates;

void main() {
    uint caster = gl_GlobalInvocationID.x;
    if (caster == 0u) {
        gnoTopHeader.v.root = GNO_TOP_NONE;
        gnoTopHeader.v.casterCount = gnoPush.count;
    }
    if (caster < gnoPush.count) gnoTopSetUp(caster, gnoCasterFacing(gnoStates.v[caster]));
}
