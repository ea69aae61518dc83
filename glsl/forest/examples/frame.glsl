// SPDX-License-Identifier: MIT
// What the passes over casters share.
#ifndef GNO_FOREST_EXAMPLE_FRAME_GLSL
#define GNO_FOREST_EXAMPLE_FRAME_GLSL
#include "../../core/bindings.glsl"
#include "../../core/caster_state.glsl"
#include "../../core/examples/frame.glsl"
#include "../bindings.glsl"
layout(constant_id = 30) const uint kViewCull = 1u;
layout(constant_id = 31) const uint kUseCover = 1u;
layout(constant_id = 32) const uint kStep = 3u;  // 3 cover, 4 count, 6 emit
#define GNO_FOREST_VIEW_CULL kViewCull
#define GNO_FOREST_USE_COVER kUseCover
#include "../assign.glsl"
layout(set = 2, binding = 0, std430) readonly buffer GnoExampleStates { uint v[]; } gnoStates;
// casters with some cells from its front on, with many from its back
layout(set = 2, binding = 1, std430) buffer GnoExampleList { uint v[]; } gnoList;

void assign(uint caster, uint lane, uint lanes) {
    GnoCellVolume v = gnoCellVolume(GNO_LIGHT, GNO_LOAD_CASTER(caster), gnoCasterFacing(gnoStates.v[caster]));
    if (kStep == 3u) gnoForestCover(v, lane, lanes);
    else if (kStep == 4u) gnoForestCount(v, lane, lanes);
    else gnoForestEmit(caster, v, lane, lanes);
}
#endif
