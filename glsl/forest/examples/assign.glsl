// SPDX-License-Identifier: MIT
// What the passes over the casters with some and with many cells share: one step for one caster.
#ifndef GNO_FOREST_EXAMPLE_ASSIGN_GLSL
#define GNO_FOREST_EXAMPLE_ASSIGN_GLSL
#define GNO_FOREST_BUILDS (GNO_FOREST_PASS_COVER | GNO_FOREST_PASS_COUNT | GNO_FOREST_PASS_EMIT)
#include "frame.glsl"

void assign(uint caster, uint lane, uint lanes) {
    GnoCellVolume v = gnoCellVolume(GNO_LIGHT, GNO_LOAD_CASTER(caster), gnoCasterFacing(gnoStates.v[caster]));
    if (kStep == 3u) gnoForestCover(v, lane, lanes);
    else if (kStep == 4u) gnoForestCount(v, lane, lanes);
    else gnoForestEmit(caster, v, lane, lanes);
}
#endif
