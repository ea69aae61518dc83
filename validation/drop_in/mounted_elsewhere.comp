#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The folder under another name and depth: includes inside it are relative.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#include "third_party/light and shade/core/bindings.glsl"
#include "third_party/light and shade/core/permutation.glsl"
#include "third_party/light and shade/core/sample.glsl"
#include "third_party/light and shade/core/caster_state.glsl"
#define GNO_TOP_BUILDS 1
#include "third_party/light and shade/top/bindings.glsl"
#include "third_party/light and shade/top/build.glsl"
#include "third_party/light and shade/top/query_hybrid.glsl"
#include "third_party/light and shade/top/query_stack.glsl"
#define GNO_CLUSTER_FORM GNO_CLUSTER_COMPACT
#define GNO_CLUSTER_BUILDS 1
#include "third_party/light and shade/clusters/bindings.glsl"
#include "third_party/light and shade/clusters/build.glsl"
#include "third_party/light and shade/clusters/merge.glsl"
#include "third_party/light and shade/clusters/volume.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { uint v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    GnoCaster t = GNO_LOAD_CASTER(at);
    gnoTopSetUp(at, gnoCasterFacing(gnoCasterState(push.light, t, true, GNO_CULL_FRONT, 0u)));
    bool inserted = gnoTopInsert(gnoPermute(at, push.count, push.seed));
    GnoViewSample s = gnoMakeViewSample(gnoSnapToGrid(push.position.xyz), at, t, push.viewer, push.light);
    bool dark = gnoTopQueryStack(s) || gnoTopQueryStackless(s) || gnoTopQueryHybrid(s) ||
                gnoDecideInShadow(push.light, t, s.position, GNO_PRECISION_CERTIFIED);
    gnoClusterSetUpVolume(at, gnoFacing(push.light, t));
    gnoClusterAddTile(gl_WorkGroupID.xy, gl_LocalInvocationID.x, s, GNO_CLUSTER_MASKS_OF_NODES);
    dark = dark || gnoClusterInShadow(uvec2(at, push.seed), s.position);
    results.v[at] = uint(inserted) + uint(dark);
}
