// SPDX-License-Identifier: MIT
// What the passes over casters share.
#ifndef GNO_FOREST_EXAMPLE_FRAME_GLSL
#define GNO_FOREST_EXAMPLE_FRAME_GLSL
#include "../../core/bindings.glsl"
#include "../../core/caster_state.glsl"
#include "../../core/examples/frame.glsl"
#include "../bindings.glsl"
#include "../../core/constant_ids.h"
layout(constant_id = GNO_ID_VIEW_CULL) const uint kViewCull = 1u;
layout(constant_id = GNO_ID_USE_COVER) const uint kUseCover = 1u;
layout(constant_id = GNO_ID_STEP) const uint kStep = 3u;  // 3 cover, 4 count, 6 emit
#define GNO_FOREST_VIEW_CULL kViewCull
#define GNO_FOREST_USE_COVER kUseCover
#include "../assign.glsl"
layout(set = 2, binding = 0, std430) readonly buffer GnoExampleStates { uint v[]; } gnoStates;
// casters with some cells from its front on, with many from its back
#if (GNO_FOREST_BUILDS) & GNO_FOREST_PASS_SORT
layout(set = 2, binding = 1, std430) buffer GnoExampleList { uint v[]; } gnoList;
#else
layout(set = 2, binding = 1, std430) readonly buffer GnoExampleList { uint v[]; } gnoList;
#endif
#endif
