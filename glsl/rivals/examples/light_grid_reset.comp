#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Before light_grid_open.comp. One invocation.
layout(local_size_x = 1) in;
#define GNO_LIGHT_GRID_BUILDS GNO_LIGHT_GRID_PASS_RESET
#include "light_grid_frame.glsl"

void main() { gnoLightGridReset(); }
