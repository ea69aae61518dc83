// SPDX-License-Identifier: MIT
// What the passes of the light grid share: buffers, settings, states.
#ifndef GNO_LIGHT_GRID_EXAMPLE_FRAME_GLSL
#define GNO_LIGHT_GRID_EXAMPLE_FRAME_GLSL
#include "../../core/bindings.glsl"
#include "../../core/caster_state.glsl"
#include "../../core/examples/frame.glsl"
#include "../../forest/bindings.glsl"
layout(constant_id = 30) const uint kViewCull = 1u;
layout(constant_id = 31) const uint kUseCover = 1u;
layout(constant_id = 33) const uint kNest = 8u;
#define GNO_FOREST_VIEW_CULL kViewCull
#define GNO_FOREST_USE_COVER kUseCover
#define GNO_LIGHT_GRID_NEST kNest
#include "../light_grid_bindings.glsl"
#include "../light_grid_build.glsl"
layout(set = 2, binding = 0, std430) readonly buffer GnoExampleStates { uint v[]; } gnoStates;
#endif
