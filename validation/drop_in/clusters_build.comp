#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_CLUSTER_FORM GNO_CLUSTER_COMPACT
#define GNO_CLUSTER_BUILDS 1
#include "gnomon/clusters/bindings.glsl"
#include "gnomon/clusters/build.glsl"
layout(local_size_x = 64) in;

void main() {
    uint at = gl_LocalInvocationID.x;
    GnoViewSample s = GnoViewSample(push.position.xyz, at);
    if (push.count == 0u) gnoClusterReset(at, 64u);
    if (push.count == 1u) GNO_CLUSTER_SLICES[at] = gnoClusterSliceAt(at);
    if (push.count == 2u) gnoClusterUp(1u, at, GNO_CLUSTER_MASKS_OF_NODES + GNO_CLUSTER_BOUNDS_OF_NODES);
    if (push.count == 3u) gnoClusterAllocate(at);
    gnoClusterMeasureDepth(s, at);
    gnoClusterAddTile(gl_WorkGroupID.xy, at, s, GNO_CLUSTER_MASKS_OF_NODES);
}
