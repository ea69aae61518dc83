// SPDX-License-Identifier: MIT
// What the passes of the light grid share: buffers, states.
#ifndef GNO_LIGHT_GRID_EXAMPLE_FRAME_GLSL
#define GNO_LIGHT_GRID_EXAMPLE_FRAME_GLSL
#include "../../core/bindings.glsl"
#include "../../core/caster_state.glsl"
#include "../../core/examples/frame.glsl"
#include "../../forest/bindings.glsl"
#include "../light_grid_bindings.glsl"
#include "../light_grid_build.glsl"
layout(set = 2, binding = 0, std430) readonly buffer GnoExampleStates { uint v[]; } gnoStates;
#endif
