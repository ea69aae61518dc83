#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Must fail with the #error of rivals/light_grid_build.glsl that names GNO_LIGHT_GRID_HEADER.
layout(push_constant) uniform Push { vec4 light; vec4 position; uint count; uint seed; } push;
#include "gnomon/forest/cells.h"
#include "gnomon/rivals/light_grid.h"
layout(set = 0, binding = 1, std430) coherent buffer Ours {
    GnoForestHeader forest;
    GnoForestGrid grid;
    GnoForestCell cells[64];
    GnoForestPair pairs[64];
    GnoForestFew few[64];
    GnoLightGridHeader header;
    GnoLightGridList lists[64];
    uint depths[64];
    GnoLightGridItem items[64];
}
ours;
#define GNO_LIGHT push.light
#define GNO_FOREST_GRID ours.grid
#define GNO_FOREST_CELLS ours.cells
#define GNO_FOREST_FEW ours.few
#define GNO_FOREST_PAIRS ours.pairs
#define GNO_FOREST_CAPACITY 64u
#define GNO_FOREST_HEADER ours.forest
#define GNO_LIGHT_GRID_LISTS ours.lists
#define GNO_LIGHT_GRID_ITEMS ours.items
#define GNO_LIGHT_GRID_CAPACITY 64u
#define GNO_LIGHT_GRID_DEPTHS ours.depths
#define GNO_LIGHT_GRID_NESTS 1u
#include "gnomon/rivals/light_grid_build.glsl"
layout(local_size_x = 64) in;
void main() {}
