#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Counts the items of each list, and in a second dispatch (kStep) puts them there. One invocation per pair of cell and caster.
#include "../../core/constant_ids.h"
layout(local_size_x = 64) in;
layout(constant_id = GNO_ID_VIEW_CULL) const uint kViewCull = 1u;
layout(constant_id = GNO_ID_STEP) const uint kStep = 5u;
#define GNO_FOREST_VIEW_CULL kViewCull
#define GNO_LIGHT_GRID_BUILDS (GNO_LIGHT_GRID_PASS_COUNT | GNO_LIGHT_GRID_PASS_EMIT)
#include "light_grid_frame.glsl"

void main() {
    uint state = gnoForestState(gnoForestHeader.v, GNO_FOREST_CAPACITY, GNO_STATE_ANY);
    uint count = state == 0u ? 0u : min(gnoForestHeader.v.pairs, GNO_FOREST_CAPACITY);
    for (uint n = gl_GlobalInvocationID.x; n < count; n += 64u * gl_NumWorkGroups.x) {
        GnoForestPair pair = gnoForestPairs.v[n];
        GnoCaster t = GNO_LOAD_CASTER(pair.caster);
        int facing = gnoCasterFacing(gnoStates.v[pair.caster]);
        if (kStep == 5u) gnoLightGridCount(pair.cell, t, facing);
        else gnoLightGridEmit(pair.cell, pair.caster, t, facing);
    }
}
