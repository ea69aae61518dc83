#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// How many work groups the passes over pairs and lists need. One invocation.
layout(local_size_x = 1) in;
#define GNO_LIGHT_GRID_BUILDS GNO_LIGHT_GRID_PASS_SIZES
#include "light_grid_frame.glsl"

void main() { gnoLightGridSizes(); }
