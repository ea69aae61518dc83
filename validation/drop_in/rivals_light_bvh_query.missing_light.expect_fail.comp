#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Must fail with the #error of rivals/light_bvh_query.glsl that names GNO_LIGHT.
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
#include "gnomon/core/bindings.glsl"
#define GNO_LIGHT_BVH_GRID ours.grid
#define GNO_LIGHT_BVH_ROOT(face_) ours.header.roots[face_]
#define GNO_LIGHT_BVH_LOAD_NODE(index_) ours.nodes[index_]
#define GNO_LIGHT_BVH_LOAD_PARENT(index_) ours.parents[index_]
#include "gnomon/rivals/light_bvh_query.glsl"
layout(local_size_x = 64) in;
void main() {}
