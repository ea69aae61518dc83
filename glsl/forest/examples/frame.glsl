// SPDX-License-Identifier: MIT
// What the passes over casters share: which of them stand for one invocation, and which for a work group.
#ifndef GNO_FOREST_EXAMPLE_FRAME_GLSL
#define GNO_FOREST_EXAMPLE_FRAME_GLSL
#include "../../core/bindings.glsl"
#include "../../core/caster_state.glsl"
#include "../../core/examples/frame.glsl"
#include "../bindings.glsl"
layout(constant_id = 30) const uint kViewCull = 1u;
layout(constant_id = 31) const uint kUseCover = 1u;
#define GNO_FOREST_VIEW_CULL kViewCull
#define GNO_FOREST_USE_COVER kUseCover
#include "../assign.glsl"
layout(set = 2, binding = 0, std430) readonly buffer GnoExampleStates { uint v[]; } gnoStates;
layout(set = 2, binding = 1, std430) buffer GnoExampleLarge { uint v[]; } gnoLarge;  // casters for a work group each
const uint kMost = 64u;  // cells that one invocation looks at
#endif
