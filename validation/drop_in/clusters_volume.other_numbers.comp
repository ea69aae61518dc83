#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way B: our buffers, other sets and bindings; another rung of the ladder.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#define GNO_CLUSTER_FORM GNO_CLUSTER_FLAT
#define GNO_CORE_SET 0
#define GNO_CORE_BINDING_CASTERS 7
#define GNO_CLUSTER_SET 2
#define GNO_CLUSTER_BINDING_FRAME 20
#define GNO_CLUSTER_BINDING_HEADER 21
#define GNO_CLUSTER_BINDING_SLICES 22
#define GNO_CLUSTER_BINDING_MASKS 23
#define GNO_CLUSTER_BINDING_SHADE 24
#define GNO_CLUSTER_BINDING_LOW 25
#define GNO_CLUSTER_BINDING_HIGH 26
#define GNO_CLUSTER_BINDING_POINTERS 27
#define GNO_CLUSTER_BINDING_VOLUMES 28
#define GNO_CLUSTER_BINDING_INFO 29
#define GNO_CLUSTER_BINDING_JOBS 30
#define GNO_PRECISION GNO_PRECISION_PUBLISHED
#include "gnomon/core/bindings.glsl"
#define GNO_CLUSTER_BUILDS 1
#include "gnomon/clusters/bindings.glsl"
#include "gnomon/clusters/volume.glsl"
layout(local_size_x = 64) in;

void main() {
    uint at = gl_GlobalInvocationID.x;
    if (at < push.count) gnoClusterSetUpVolume(at, int(push.seed) - 1);
}
