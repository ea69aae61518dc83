#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Must fail with the #error of clusters/nodes.glsl that names GNO_CLUSTER_LAYOUT.
#include "gnomon/clusters/cluster.h"
layout(set = 0, binding = 1, std140) uniform View { GnoClusterFrame frame; GnoClusterLayout tree; } view;
layout(set = 0, binding = 2, std430) buffer Ours {
    GnoClusterHeader header;
    float slices[64];
    uint masks[64];
    uint shade[64];
    float lows[64];
    float highs[64];
    uvec2 pointers[64];
    vec4 volumes[64];
    uvec2 infos[64];
    uvec2 jobs[64];
} ours;
#define GNO_CLUSTER_FRAME view.frame
#define GNO_CLUSTER_FORM 1u
#define GNO_CLUSTER_SLICES ours.slices
#define GNO_CLUSTER_MASKS ours.masks
#define GNO_CLUSTER_LOW ours.lows
#define GNO_CLUSTER_HIGH ours.highs
#define GNO_CLUSTER_POINTERS ours.pointers
#include "gnomon/clusters/nodes.glsl"
layout(local_size_x = 64) in;
void main() {}
