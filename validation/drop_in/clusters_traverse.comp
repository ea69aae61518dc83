#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
// SPDX-License-Identifier: MIT
// Way A: our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#define GNO_CLUSTER_FORM GNO_CLUSTER_COMPACT
#include "gnomon/core/bindings.glsl"
#include "gnomon/core/sample.glsl"
#define GNO_CLUSTER_BUILDS 1
#include "gnomon/clusters/bindings.glsl"
layout(set = 2, binding = 0, rgba32ui) uniform readonly uimage2D samples;
#define GNO_CLUSTER_LOAD_SAMPLE(pixel_) gnoUnpackViewSample(imageLoad(samples, pixel_))
#include "gnomon/clusters/traverse.glsl"
layout(local_size_x = 64) in;

void main() {
    if (push.count == 0u) gnoClusterExpand();
    else gnoClusterFinish();
}
