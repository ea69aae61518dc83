#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// After the items are put (light_grid_pairs.comp): those of each list in order. One work group per 64 lists.
layout(local_size_x = 64) in;
#define GNO_LIGHT_GRID_BUILDS GNO_LIGHT_GRID_PASS_SORT
#include "light_grid_frame.glsl"
#include "../light_grid_sort.glsl"

void main() {
    uint groups =
        gnoLightGridLists(gnoCellCount(gnoForestGrid.v.resolution, gnoForestGrid.v.faces), min(GNO_LIGHT_GRID_HEADER.nests, GNO_LIGHT_GRID_NESTS)) /
        64u;
    for (uint group = gl_WorkGroupID.x; group < groups; group += gl_NumWorkGroups.x) {
        gnoLightGridSort(group, gl_LocalInvocationIndex);
        if (gl_LocalInvocationIndex == 0u) gnoLightGridFinish();
    }
}
