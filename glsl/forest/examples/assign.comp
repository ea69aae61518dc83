#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Steps 2, 3 and 5 for the casters with few cells: one invocation per caster. Step 2 lists the others.
layout(local_size_x = 64) in;
layout(constant_id = 32) const uint kStep = 2u;
#include "../../core/permutation.glsl"
#include "frame.glsl"

void main() {
    if (gl_GlobalInvocationID.x >= gnoPush.count) return;
    uint caster = gl_GlobalInvocationID.x;
    if (kStep == 5u) caster = gnoPermute(caster, gnoPush.count, gnoPush.seed);  // so that each cell has its casters in random order
    int facing = gnoCasterFacing(gnoStates.v[caster]);
    if (facing == 0) return;
    GnoCellVolume v = gnoCellVolume(GNO_LIGHT, GNO_LOAD_CASTER(caster), facing);
    uint span = gnoForestSpan(v);
    if (span > kMost) {
        if (kStep == 2u) gnoLarge.v[atomicAdd(gnoForestHeader.v.large, 1u)] = caster;
    } else if (kStep == 2u) {
        if (kUseCover != 0u && span >= 9u) gnoForestCover(v, 0u, 1u);  // a covered cell has neighbours on all sides that are met
    } else if (kStep == 3u) {
        gnoForestCount(v, 0u, 1u);
    } else {
        gnoForestEmit(caster, v, 0u, 1u);
    }
}
