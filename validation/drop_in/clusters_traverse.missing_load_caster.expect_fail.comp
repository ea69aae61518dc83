#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
// SPDX-License-Identifier: MIT
// Must fail with the #error of clusters/traverse.glsl that names GNO_LOAD_CASTER.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#define GNO_CLUSTER_FORM GNO_CLUSTER_COMPACT
#include "gnomon/clusters/bindings.glsl"
#define GNO_CLUSTER_LOAD_SAMPLE(pixel_) GnoViewSample(vec3(0.0), 0u)
#include "gnomon/clusters/traverse.glsl"
layout(local_size_x = 64) in;
void main() {}
