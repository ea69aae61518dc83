#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#define GNO_CLUSTER_FORM GNO_CLUSTER_COMPACT
#include "gnomon/core/bindings.glsl"
#include "gnomon/clusters/bindings.glsl"
#include "gnomon/clusters/volume.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    gnoClusterSetUpVolume(at, int(push.seed) - 1);
    result = GNO_CLUSTER_VOLUMES[at];
}
