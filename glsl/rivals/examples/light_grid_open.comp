#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// In place of forest/examples/allocate.comp. One invocation per cell, whole work groups.
layout(local_size_x = 64) in;
#include "light_grid_frame.glsl"

void main() { gnoLightGridOpen(gl_GlobalInvocationID.x); }
