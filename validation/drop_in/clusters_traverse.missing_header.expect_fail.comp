#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
// SPDX-License-Identifier: MIT
// Must fail with the #error of clusters/traverse.glsl that names GNO_CLUSTER_HEADER.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#include "gnomon/core/bindings.glsl"
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
#define GNO_CLUSTER_LAYOUT view.tree
#define GNO_CLUSTER_FORM 1u
#define GNO_CLUSTER_SLICES ours.slices
#define GNO_CLUSTER_MASKS ours.masks
#define GNO_CLUSTER_LOW ours.lows
#define GNO_CLUSTER_HIGH ours.highs
#define GNO_CLUSTER_POINTERS ours.pointers
#define GNO_CLUSTER_SHADE ours.shade
#define GNO_CLUSTER_VOLUMES ours.volumes
#define GNO_CLUSTER_INFO ours.infos
#define GNO_CLUSTER_JOBS ours.jobs
#define GNO_CLUSTER_LOAD_SAMPLE(pixel_) GnoViewSample(vec3(0.0), 0u)
#include "gnomon/clusters/traverse.glsl"
layout(local_size_x = 64) in;
void main() {}
