#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way B: our buffers, other sets and bindings.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_CLUSTER_FORM GNO_CLUSTER_FLAT
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
#include "gnomon/clusters/bindings.glsl"
#include "gnomon/clusters/merge.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    result = vec4(gnoClusterInShadow(uvec2(at, push.seed), push.position.xyz));
    results.v[at] = result;
}
