// SPDX-License-Identifier: MIT
// What the passes of the build share.
#ifndef GNO_LIGHT_BVH_EXAMPLE_FRAME_GLSL
#define GNO_LIGHT_BVH_EXAMPLE_FRAME_GLSL
#include "../../core/bindings.glsl"
#include "../../core/caster_state.glsl"
#include "../../core/examples/frame.glsl"
#include "../light_bvh_bindings.glsl"
#include "../light_bvh_build.glsl"
layout(local_size_x = 64) in;
#endif
