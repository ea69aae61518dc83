#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Step 2: casters by the number of their cells. One invocation per caster.
layout(local_size_x = 64) in;
#include "frame.glsl"

void main() {
    uint caster = gl_GlobalInvocationID.x;
    if (caster >= gnoPush.count) return;
    if (gnoCasterFacing(gnoStates.v[caster]) == 0) {
        gnoForestNone(caster);
        return;
    }
    uint size = gnoForestSort(caster, gnoCellSight(GNO_LIGHT, GNO_LOAD_CASTER(caster)));
    if (size == GNO_FOREST_SOME_CELLS) gnoList.v[atomicAdd(gnoForestHeader.v.some, 1u)] = caster;
    if (size == GNO_FOREST_MANY_CELLS) gnoList.v[gnoPush.count - 1u - atomicAdd(gnoForestHeader.v.many, 1u)] = caster;
}
