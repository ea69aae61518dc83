#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Must fail with the #error of forest/assign.glsl that names GNO_FOREST_FEW.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/forest/cells.h"
layout(set = 0, binding = 1, std430) buffer Ours {
    GnoForestHeader header;
    GnoForestGrid grid;
    GnoForestCell cells[64];
    GnoForestFew few[64];
    GnoForestPair pairs[64];
}
ours;
#define GNO_LIGHT push.light
#define GNO_FOREST_GRID ours.grid
#define GNO_FOREST_CELLS ours.cells
#define GNO_FOREST_PAIRS ours.pairs
#define GNO_FOREST_CAPACITY 64u
#define GNO_FOREST_HEADER ours.header
#include "gnomon/forest/assign.glsl"
layout(local_size_x = 64) in;
void main() {}
