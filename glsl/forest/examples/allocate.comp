#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Step 4: one invocation per cell.
layout(local_size_x = 64) in;
#include "../../core/examples/frame.glsl"
#include "../bindings.glsl"
#include "../assign.glsl"

void main() {
    if (gl_GlobalInvocationID.x < gnoCellCount(gnoForestGrid.v.resolution, gnoForestGrid.v.faces)) gnoForestAllocate(gl_GlobalInvocationID.x);
}
