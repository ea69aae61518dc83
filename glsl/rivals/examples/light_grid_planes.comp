#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Planes of the casters, for the queries that ask them first. One invocation per caster.
layout(local_size_x = 64) in;
#define GNO_LIGHT_GRID_BUILDS GNO_LIGHT_GRID_PASS_PLANES
#include "light_grid_frame.glsl"
#include "../light_grid_planes.glsl"

void main() {
    uint caster = gl_GlobalInvocationID.x;
    if (caster == 0u) gnoLightGridFinishPlanes();
    if (caster >= gnoPush.count) return;
    int facing = gnoCasterFacing(gnoStates.v[caster]);
    if (facing == 0) return;
    for (uint place = 0u; place < 4u; ++place)
        gnoGridPlanes.v[4u * caster + place] = gnoLightGridPlane(GNO_LIGHT, GNO_LOAD_CASTER(caster), facing, place);
}
