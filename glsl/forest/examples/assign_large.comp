#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Steps 2, 3 and 5 for the listed casters: one work group per caster.
layout(local_size_x = 64) in;
layout(constant_id = 32) const uint kStep = 2u;
#include "frame.glsl"

void main() {
    for (uint n = gl_WorkGroupID.x; n < gnoForestHeader.v.large; n += gl_NumWorkGroups.x) {
        uint caster = gnoLarge.v[n];
        GnoCellVolume v = gnoCellVolume(GNO_LIGHT, GNO_LOAD_CASTER(caster), gnoCasterFacing(gnoStates.v[caster]));
        if (kStep == 2u) {
            if (kUseCover != 0u) gnoForestCover(v, gl_LocalInvocationIndex, 64u);
        } else if (kStep == 3u) {
            gnoForestCount(v, gl_LocalInvocationIndex, 64u);
        } else {
            gnoForestEmit(caster, v, gl_LocalInvocationIndex, 64u);
        }
    }
}
