#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Shadow volumes, one invocation per caster.
#include "../../core/constant_ids.h"
layout(local_size_x = 64) in;
layout(constant_id = GNO_ID_PRECISION) const uint kPrecision = 2u;
#define GNO_PRECISION kPrecision
layout(constant_id = GNO_ID_FORM) const uint kForm = 1u;
#define GNO_CLUSTER_FORM kForm
#include "../../core/bindings.glsl"
#include "../../core/caster_state.glsl"
#include "../../core/examples/frame.glsl"
#define GNO_CLUSTER_BUILDS GNO_CLUSTER_PASS_VOLUMES
#include "../bindings.glsl"
#include "../volume.glsl"
layout(set = 2, binding = 0, std430) readonly buffer GnoExampleStates { uint v[]; } gnoStates;

void main() {
    uint caster = gl_GlobalInvocationID.x;
    if (caster == 0u) gnoClusterFinishVolumes();
    if (caster < gnoPush.count) gnoClusterSetUpVolume(caster, gnoCasterFacing(gnoStates.v[caster]));
}
