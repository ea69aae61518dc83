#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#define GNO_CLUSTER_FORM GNO_CLUSTER_COMPACT
#include "gnomon/core/bindings.glsl"
#define GNO_CLUSTER_BUILDS GNO_CLUSTER_PASS_VOLUMES
#include "gnomon/clusters/bindings.glsl"
#include "gnomon/clusters/volume.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    gnoClusterSetUpVolume(at, int(push.seed) - 1);
    if (at == 0u) gnoClusterFinishVolumes();
    result = GNO_CLUSTER_VOLUMES[at];
    results.v[at] = result;
}
