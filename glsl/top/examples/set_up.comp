#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Dispatch 1 of a TOP tree: one invocation per caster.
#include "../../core/constant_ids.h"
layout(local_size_x = 64, local_size_x_id = GNO_ID_GROUP_SIZE) in;
layout(constant_id = GNO_ID_PRECISION) const uint kPrecision = 2u;
#define GNO_PRECISION kPrecision
#include "../../core/bindings.glsl"
#include "../../core/caster_state.glsl"
#include "../../core/examples/frame.glsl"
#define GNO_TOP_BUILDS GNO_TOP_PASS_SET_UP
#include "../bindings.glsl"
#include "../build.glsl"
layout(set = 2, binding = 0, std430) readonly buffer GnoExampleStates { uint v[]; } gnoStates;

void main() {
    uint caster = gl_GlobalInvocationID.x;
    if (caster == 0u) gnoTopBegin(gnoPush.count, gnoState(GNO_PRECISION));
    if (caster < gnoPush.count) gnoTopSetUp(caster, gnoCasterFacing(gnoStates.v[caster]));
}
