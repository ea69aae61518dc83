#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Casters by the number of their cells. One invocation per caster.
layout(local_size_x = 64) in;
#define GNO_FOREST_BUILDS GNO_FOREST_PASS_SORT
#include "frame.glsl"

void main() {
    uint caster = gl_GlobalInvocationID.x;
    if (caster >= gnoPush.count) return;
    bool reset = gnoForestHeader.v.state == gnoState(GNO_STATE_ANY);  // or the counters below may be any number
    if (!reset || gnoCasterFacing(gnoStates.v[caster]) == 0) {
        gnoForestNone(caster);
        return;
    }
    uint size = gnoForestSort(caster, gnoCellSight(GNO_LIGHT, GNO_LOAD_CASTER(caster)));
    if (size == GNO_FOREST_SOME_CELLS) gnoList.v[atomicAdd(gnoForestHeader.v.some, 1u)] = caster;
    if (size == GNO_FOREST_MANY_CELLS) gnoList.v[gnoPush.count - 1u - atomicAdd(gnoForestHeader.v.many, 1u)] = caster;
}
