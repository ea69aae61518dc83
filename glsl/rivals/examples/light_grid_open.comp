#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// In place of forest/examples/allocate.comp. One invocation per cell, whole work groups.
layout(local_size_x = 64) in;
#include "../../core/constant_ids.h"
layout(constant_id = GNO_ID_NEST) const uint kNest = 8u;
#define GNO_LIGHT_GRID_NEST kNest
#define GNO_FOREST_BUILDS GNO_FOREST_PASS_ALLOCATE
#define GNO_LIGHT_GRID_BUILDS GNO_LIGHT_GRID_PASS_OPEN
#include "light_grid_frame.glsl"

void main() { gnoLightGridOpen(gl_GlobalInvocationID.x); }
