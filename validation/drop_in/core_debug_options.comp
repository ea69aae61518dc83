#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
// SPDX-License-Identifier: MIT
// core/debug.glsl: a report and a limit of the engine's own, in the other modules that have loops to bound.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
uint reports = 0u;
#define GNO_DEBUG 1
#define GNO_DEBUG_LIMIT push.count
#define GNO_DEBUG_REPORT(what) ++reports
#define GNO_LIGHT push.light
#define GNO_CLUSTER_FORM GNO_CLUSTER_COMPACT
#define GNO_CLUSTER_LOAD_SAMPLE(pixel_) GnoViewSample(push.position.xyz, uint((pixel_).x))
#define GNO_CLUSTER_BUILDS GNO_CLUSTER_PASS_EXPAND
#define GNO_LIGHT_GRID_SET 2
#define GNO_CLUSTER_SET 4
#include "gnomon/core/bindings.glsl"
#include "gnomon/core/debug.glsl"
#include "gnomon/clusters/bindings.glsl"
#include "gnomon/clusters/traverse.glsl"
#include "gnomon/forest/bindings.glsl"
#include "gnomon/rivals/light_bvh_bindings.glsl"
#include "gnomon/rivals/light_bvh_query.glsl"
#include "gnomon/rivals/light_grid_bindings.glsl"
#include "gnomon/rivals/light_grid_query.glsl"
layout(local_size_x = 64) in;
layout(set = 5, binding = 0, std430) writeonly buffer Results { uint v[]; } results;

void main() {
    gnoClusterExpand();
    GnoViewSample s = GnoViewSample(push.position.xyz, push.seed);
    uint answers = gnoLightBvhAnswer(s) + gnoLightBvhStacklessAnswer(s) + gnoLightGridAnswer(s);
    results.v[gl_GlobalInvocationID.x] = 16u * answers + reports;
}
