#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Before all: empty cells. One invocation per cell.
layout(local_size_x = 64) in;
#define GNO_FOREST_BUILDS GNO_FOREST_PASS_RESET
#include "../../core/examples/frame.glsl"
#include "../bindings.glsl"
#include "../assign.glsl"

void main() {
    uint cell = gl_GlobalInvocationID.x;
    if (cell < gnoCellCount(gnoForestGrid.v.resolution, gnoForestGrid.v.faces)) gnoForestReset(cell);
}
