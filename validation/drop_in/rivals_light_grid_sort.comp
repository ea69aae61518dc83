#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: our buffers, our numbers.
#define GNO_LIGHT_GRID_BUILDS 1
#include "gnomon/rivals/light_grid_bindings.glsl"
#include "gnomon/rivals/light_grid_sort.glsl"
layout(local_size_x = 64) in;

void main() { gnoLightGridSort(gl_WorkGroupID.x, gl_LocalInvocationIndex); }
