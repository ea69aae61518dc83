#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
// SPDX-License-Identifier: MIT
// Way B: our buffers, other sets and bindings; every option at another value.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#define GNO_CLUSTER_FORM GNO_CLUSTER_IMPLICIT
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
#define GNO_CLUSTER_BIAS 0.001f
#define GNO_CLUSTER_LAYERS 1
#define GNO_CLUSTER_IS_OPAQUE(caster_) (((caster_) & 1u) == 0u)
#define GNO_CLUSTER_LAYER(c_, t_, pixel_, p_) ((c_) > 3u && (t_).a.x < (p_).x && (pixel_).x > 1u)
#include "gnomon/core/bindings.glsl"
#include "gnomon/core/sample.glsl"
#define GNO_CLUSTER_BUILDS 1
#include "gnomon/clusters/bindings.glsl"
layout(set = 3, binding = 0, rgba32ui) uniform readonly uimage2D samples;
layout(set = 3, binding = 1, r32ui) uniform uimage2D tests;
layout(set = 3, binding = 2, std430) buffer Steps { uint v[]; } steps;
#define GNO_CLUSTER_LOAD_SAMPLE(pixel_) gnoUnpackViewSample(imageLoad(samples, pixel_))
#define GNO_CLUSTER_ON_LEAF_TEST(pixel_) imageAtomicAdd(tests, ivec2(pixel_), 1u)
#define GNO_CLUSTER_ON_JOB(job_) if (subgroupElect()) steps.v[job_] = gnoClusterSteps
#include "gnomon/clusters/traverse.glsl"
layout(local_size_x = 64) in;

void main() {
    if (push.count == 0u) gnoClusterExpand();
    else gnoClusterFinish();
}
