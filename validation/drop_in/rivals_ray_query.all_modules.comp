#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_ray_query : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
// SPDX-License-Identifier: MIT
// All modules in one shader, those that need ray queries included: no two names clash.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#define GNO_CLUSTER_FORM GNO_CLUSTER_COMPACT
#define GNO_SHADOW_MAP_MEASURES 1
#define GNO_SORT_LENGTH push.count
#define GNO_SORT_SHIFT push.seed
#define GNO_SORT_KEYS gnoLightBvhKeys.v
#define GNO_SORT_VALUES gnoLightBvhOrder.v
#define GNO_SORT_SORTED_KEYS gnoLightBvhMasks.v
#define GNO_SORT_SORTED_VALUES gnoLightBvhParents.v
#define GNO_SORT_COUNTS gnoLightBvhSums.v
#define GNO_PREFIX_WORDS gnoLightBvhSums.v
#define GNO_CLUSTER_LOAD_SAMPLE(pixel_) GnoViewSample(push.position.xyz, uint((pixel_).x))
#include "gnomon/core/bindings.glsl"
#include "gnomon/core/caster_state.glsl"
#include "gnomon/core/counters.glsl"
#include "gnomon/core/debug.glsl"
#include "gnomon/core/decide.glsl"
#include "gnomon/core/hit_weights.glsl"
#include "gnomon/core/int128.glsl"
#include "gnomon/core/light.glsl"
#include "gnomon/core/material.h"
#define GNO_TRANSMITTANCE_ADDS 1
#include "gnomon/core/material_bindings.glsl"
#include "gnomon/core/orient3d.glsl"
#include "gnomon/core/permutation.glsl"
#include "gnomon/core/portable.h"
#include "gnomon/core/sample.glsl"
#include "gnomon/core/sample_from_depth.glsl"
#include "gnomon/core/shared_types.h"
#include "gnomon/core/state.h"
#include "gnomon/core/version.h"
#include "gnomon/core/transmittance.glsl"
#include "gnomon/core/transmittance_sum.glsl"
#include "gnomon/core/version.h"
#include "gnomon/core/constant_ids.h"
#define GNO_CLUSTER_BUILDS 1
#include "gnomon/clusters/bindings.glsl"
#include "gnomon/clusters/bounds.glsl"
#include "gnomon/clusters/build.glsl"
#include "gnomon/clusters/cluster.h"
#include "gnomon/clusters/key.glsl"
#include "gnomon/clusters/merge.glsl"
#include "gnomon/clusters/nodes.glsl"
#include "gnomon/clusters/traverse.glsl"
#include "gnomon/clusters/volume.glsl"
#define GNO_FOREST_TREES 0
#define GNO_FOREST_BUILDS 1
#include "gnomon/forest/bindings.glsl"
#include "gnomon/forest/assign.glsl"
#include "gnomon/forest/cells.glsl"
#include "gnomon/forest/cells.h"
#include "gnomon/rivals/ray_query_bindings.glsl"
#include "gnomon/rivals/ray_query.glsl"
#define GNO_LIGHT_GRID_BUILDS 1
#include "gnomon/rivals/light_grid_bindings.glsl"
#include "gnomon/rivals/light_grid.h"
#include "gnomon/rivals/light_grid_build.glsl"
#include "gnomon/rivals/light_grid_place.glsl"
#include "gnomon/rivals/light_grid_planes.glsl"
#include "gnomon/rivals/light_grid_query.glsl"
#include "gnomon/rivals/light_grid_sort.glsl"
#define GNO_LIGHT_BVH_BUILDS 1
#include "gnomon/rivals/light_bvh_bindings.glsl"
#include "gnomon/rivals/light_bvh.h"
#include "gnomon/rivals/light_bvh_bounds.glsl"
#include "gnomon/rivals/light_bvh_build.glsl"
#include "gnomon/rivals/light_bvh_query.glsl"
#include "gnomon/core/prefix_sum.glsl"
#include "gnomon/core/radix_sort.glsl"
#include "gnomon/core/radix_sort.h"
#include "gnomon/rivals/ray_query_index.glsl"
#include "gnomon/shadow_map/bindings.glsl"
#include "gnomon/shadow_map/map_bindings.glsl"
#include "gnomon/shadow_map/fit.glsl"
#include "gnomon/shadow_map/project.glsl"
#include "gnomon/shadow_map/query.glsl"
#include "gnomon/shadow_map/view.h"
#define GNO_TOP_BUILDS 1
#include "gnomon/top/bindings.glsl"
#include "gnomon/top/build.glsl"
#include "gnomon/top/node.h"
#include "gnomon/top/plane.glsl"
#include "gnomon/top/query_hybrid.glsl"
#include "gnomon/top/query_stack.glsl"
#include "gnomon/top/query_stackless.glsl"
#include "gnomon/top/visit.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { uint v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    GnoCaster t = GNO_LOAD_CASTER(at);
    gnoTopSetUp(at, gnoCasterFacing(gnoCasterState(push.light, t, true, GNO_CULL_FRONT, 0u)));
    bool inserted = gnoTopInsert(gnoPermute(at, push.count, push.seed));
    GnoViewSample s = gnoMakeViewSample(gnoSnapToGrid(push.position.xyz), at, t, push.viewer, push.light);
    bool dark = gnoRayQueryInShadow(s) || gnoTopQueryStack(s) || gnoTopQueryStackless(s) || gnoTopQueryHybrid(s) ||
                gnoDecideInShadow(push.light, t, s.position, GNO_PRECISION_CERTIFIED);
    gnoAddTransmittance(at, gnoTransmittance(at, t, push.light, s.position));
    gnoClusterSetUpVolume(at, gnoFacing(push.light, t));
    gnoClusterMeasureDepth(s, gl_LocalInvocationID.x);
    gnoClusterAddTile(gl_WorkGroupID.xy, gl_LocalInvocationID.x, s, GNO_CLUSTER_MASKS_OF_NODES);
    gnoClusterExpand();
    dark = dark || gnoClusterInShadow(uvec2(at, push.seed), s.position);
    gnoSortCount(gl_WorkGroupID.x, gl_LocalInvocationID.x);
    gnoLightBvhSplit(at);
    dark = dark || gnoLightBvhQuery(s);
    results.v[at] = uint(inserted) + uint(dark);
}
