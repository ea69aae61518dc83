#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Before all: empty cells. One invocation per cell.
layout(local_size_x = 64) in;
#include "../bindings.glsl"

void main() {
    uint cell = gl_GlobalInvocationID.x;
    if (cell == 0u) gnoForestHeader.v = GnoForestHeader(0u, 1u, 1u, 0u, 0u, 1u, 1u, 0u, 0u, 1u, 1u, 0u, 0u);
    if (cell < gnoCellCount(gnoForestGrid.v.resolution, gnoForestGrid.v.faces))
        gnoForestCells.v[cell] = GnoForestCell(0u, GNO_FOREST_NONE, 0u, GNO_FOREST_NONE);
}
