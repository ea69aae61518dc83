#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Must fail with the #error of rivals/light_bvh_build.glsl that names GNO_LIGHT_BVH_KEYS.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/forest/cells.h"
#include "gnomon/rivals/light_bvh.h"
layout(set = 0, binding = 1, std430) buffer Ours {
    GnoLightBvhHeader header;
    GnoForestGrid grid;
    GnoLightBvhLevel levels[GNO_LIGHT_BVH_LEVELS];
    GnoLightBvhBox references[64];
    GnoLightBvhBox boxes[128];
    GnoLightBvhBox splits[64];
    GnoLightBvhNode nodes[64];
    uint masks[64], sums[64], keys[64], order[64], parents[64];
} ours;
#define GNO_LIGHT push.light
#define GNO_LIGHT_BVH_GRID ours.grid
#define GNO_LIGHT_BVH_MASKS ours.masks
#define GNO_LIGHT_BVH_SUMS ours.sums
#define GNO_LIGHT_BVH_HEADER ours.header
#define GNO_LIGHT_BVH_LEVEL_TABLE ours.levels
#define GNO_LIGHT_BVH_REFERENCES ours.references
#define GNO_LIGHT_BVH_CAPACITY 64u
#define GNO_LIGHT_BVH_ORDER ours.order
#define GNO_LIGHT_BVH_BOXES ours.boxes
#define GNO_LIGHT_BVH_SPLITS ours.splits
#define GNO_LIGHT_BVH_NODES ours.nodes
#define GNO_LIGHT_BVH_PARENTS ours.parents
#include "gnomon/rivals/light_bvh_build.glsl"
layout(local_size_x = 64) in;
void main() {}
