// SPDX-License-Identifier: MIT
// gnomon shadow_map/query.glsl : is a view sample in shadow by the shadow map? An approximation: the caster nearest to the light at the centre of a
// texel answers for all of the texel, so edges are as wrong as texels are wide, and surfaces darken themselves unless a bias moves them away. No
// filter: the question has two answers.
//
//   uint gnoShadowMapAnswer(GnoViewSample s)         asks the first view that holds the sample; none: GNO_VISIBILITY_LIT. s.own is not looked at.
//                                                    GNO_VISIBILITY_UNKNOWN: there are no views; whether the map was drawn, nobody knows
//   bool gnoShadowMapQuery(GnoViewSample s)          the same for two answers: true where it is not lit
//
// Bias: the caller draws the map with depth bias (vkCmdSetDepthBias) of slope factor -b: the depth that a caster's plane has b texels further along
// its steepest axis. A sample and the centre of its texel are half a texel apart along either axis, so 1 texel keeps a plane from darkening itself
// but for rounding: half the slope along x and half the slope along y make at most the larger slope. The constant part is in the views
// (gnoShadowMapConstantBias).
//
// Space      sample on the scene grid
// Stages     any; may diverge
// Requires   #version 450, no extension
// Reads      views, map
// Cost       a projection per view until one holds the sample; one texel
//
// Macro                                   required  default  meaning
// GNO_LIGHT                               yes       -        vec4, core/light.glsl
// GNO_SHADOW_MAP_STATE                    yes       -        uint: gnoState(GNO_STATE_ANY) where there are views (core/state.h)
// GNO_SHADOW_MAP_VIEW_COUNT               yes       -        uint
// GNO_SHADOW_MAP_SIZE                     yes       -        uint, texels along a side
// GNO_SHADOW_MAP_LOAD_VIEW(i)             yes       -        GnoShadowMapView
// GNO_SHADOW_MAP_LOAD_DEPTH(i, texel)     yes       -        float of view i at a uvec2
#ifndef GNO_SHADOW_MAP_QUERY_GLSL
#define GNO_SHADOW_MAP_QUERY_GLSL
#include "project.glsl"
#ifndef GNO_LIGHT
#error "shadow_map/query.glsl: define GNO_LIGHT"
#endif
#ifndef GNO_SHADOW_MAP_STATE
#error "shadow_map/query.glsl: define GNO_SHADOW_MAP_STATE or include shadow_map/bindings.glsl before this file"
#endif
#ifndef GNO_SHADOW_MAP_VIEW_COUNT
#error "shadow_map/query.glsl: define GNO_SHADOW_MAP_VIEW_COUNT or include shadow_map/bindings.glsl before this file"
#endif
#ifndef GNO_SHADOW_MAP_SIZE
#error "shadow_map/query.glsl: define GNO_SHADOW_MAP_SIZE or include shadow_map/bindings.glsl before this file"
#endif
#ifndef GNO_SHADOW_MAP_LOAD_VIEW
#error "shadow_map/query.glsl: define GNO_SHADOW_MAP_LOAD_VIEW(index) or include shadow_map/bindings.glsl before this file"
#endif
#ifndef GNO_SHADOW_MAP_LOAD_DEPTH
#error "shadow_map/query.glsl: define GNO_SHADOW_MAP_LOAD_DEPTH(index, texel) or include shadow_map/map_bindings.glsl before this file"
#endif

uint gnoShadowMapAnswer(GnoViewSample s_) {
    if (GNO_SHADOW_MAP_STATE != gnoState(GNO_STATE_ANY)) return GNO_VISIBILITY_UNKNOWN;
    vec3 q_ = gnoFromLight(GNO_LIGHT, s_.position);
    for (uint i_ = 0u; i_ < GNO_SHADOW_MAP_VIEW_COUNT; ++i_) {
        GnoShadowMapView view_ = GNO_SHADOW_MAP_LOAD_VIEW(i_);
        vec4 clip_ = gnoShadowMapClip(view_, q_);
        if (!gnoShadowMapHolds(clip_)) continue;
        uvec2 texel_ = gnoShadowMapTexel(clip_, GNO_SHADOW_MAP_SIZE);
        return GNO_SHADOW_MAP_LOAD_DEPTH(i_, texel_) > gnoShadowMapDepth(view_, clip_) ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT;
    }
    return GNO_VISIBILITY_LIT;
}

bool gnoShadowMapQuery(GnoViewSample s_) { return gnoShadowMapAnswer(s_) != GNO_VISIBILITY_LIT; }
#endif
