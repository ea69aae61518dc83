#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way C: all arrays inside one buffer of the engine's, frame and layout in a uniform block.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/clusters/cluster.h"
layout(set = 0, binding = 1, std140) uniform View { GnoClusterFrame frame; GnoClusterLayout tree; } view;
layout(set = 0, binding = 2, std430) buffer Ours {
    float slices[64];
    uint masks[64];
    float lows[64];
    float highs[64];
    uvec2 pointers[64];
} ours;
#define GNO_CLUSTER_FRAME view.frame
#define GNO_CLUSTER_LAYOUT view.tree
#define GNO_CLUSTER_FORM push.count
#define GNO_CLUSTER_SLICES ours.slices
#define GNO_CLUSTER_MASKS ours.masks
#define GNO_CLUSTER_LOW ours.lows
#define GNO_CLUSTER_HIGH ours.highs
#define GNO_CLUSTER_POINTERS ours.pointers
#include "gnomon/clusters/nodes.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    uint key = gnoClusterLeafKey(uvec2(at, push.seed), push.position.x);
    uvec2 pixel = gnoClusterTilePixel(GNO_CLUSTER_FORM, uvec2(at, push.seed), push.count);
    results.v[at] = vec4(float(gnoClusterBoxIndex(1u, key)), float(gnoClusterSliceOf(push.position.x)), vec2(pixel));
}
