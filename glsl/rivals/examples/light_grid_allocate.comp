#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Where the items of each list go. One invocation per list.
layout(local_size_x = 64) in;
#define GNO_LIGHT_GRID_BUILDS GNO_LIGHT_GRID_PASS_ALLOCATE
#include "light_grid_frame.glsl"

void main() {
    uint groups =
        gnoLightGridLists(gnoCellCount(gnoForestGrid.v.resolution, gnoForestGrid.v.faces), min(GNO_LIGHT_GRID_HEADER.nests, GNO_LIGHT_GRID_NESTS)) /
        64u;
    for (uint group = gl_WorkGroupID.x; group < groups; group += gl_NumWorkGroups.x) gnoLightGridAllocate(64u * group + gl_LocalInvocationIndex);
}
