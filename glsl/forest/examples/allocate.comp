#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Where the casters of each cell go in the pool. One invocation per cell.
layout(local_size_x = 64) in;
#include "../../core/examples/frame.glsl"
#define GNO_FOREST_BUILDS GNO_FOREST_PASS_ALLOCATE
#include "../bindings.glsl"
#include "../assign.glsl"

void main() {
    if (gl_GlobalInvocationID.x < gnoCellCount(gnoForestGrid.v.resolution, gnoForestGrid.v.faces)) gnoForestAllocate(gl_GlobalInvocationID.x);
}
