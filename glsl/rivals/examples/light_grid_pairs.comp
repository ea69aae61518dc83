#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Steps 5 (count) and 7 (emit). One invocation per pair of cell and caster.
layout(local_size_x = 64) in;
layout(constant_id = 32) const uint kStep = 5u;
#include "light_grid_frame.glsl"

void main() {
    uint count = min(gnoForestHeader.v.pairs, GNO_FOREST_CAPACITY);
    for (uint n = gl_GlobalInvocationID.x; n < count; n += 64u * gl_NumWorkGroups.x) {
        GnoForestPair pair = gnoForestPairs.v[n];
        GnoCaster t = GNO_LOAD_CASTER(pair.caster);
        int facing = gnoCasterFacing(gnoStates.v[pair.caster]);
        if (kStep == 5u) gnoLightGridCount(pair.cell, t, facing);
        else gnoLightGridEmit(pair.cell, pair.caster, t, facing);
    }
}
