// SPDX-License-Identifier: MIT
// gnomon shadow_map/fit.glsl : which views hold view samples, and where in them; one invocation per view sample, before the maps are drawn.
// After Lauritzen, Salvi, Lefohn, "Sample Distribution Shadow Maps", I3D 2011.
//
//   void gnoShadowMapMeasure(GnoViewSample s)        widens the bounds of the first view that holds the sample
//
// Per view four numbers, 0 before (reset them): 2^24 + 1 minus the least, and 1 plus the largest position to the right, and both downwards, in steps
// of 2^-24 of the view's width. gnoShadowMapFit of view.h reads them; all four stay 0 in a view without samples: it need not be drawn.
//
// Space      sample on the scene grid
// Stages     any with storage buffers and atomics on them (fragment stage: fragmentStoresAndAtomics); may diverge
// Requires   #version 450, no extension
// Writes     bounds, by atomicMax only
// Cost       a projection per view until one holds the sample; four atomics
//
// Macro                         required  default  meaning
// GNO_LIGHT                     yes       -        vec4, core/light.glsl
// GNO_SHADOW_MAP_VIEW_COUNT     yes       -        uint
// GNO_SHADOW_MAP_LOAD_VIEW(i)   yes       -        GnoShadowMapView
// GNO_SHADOW_MAP_BOUNDS         yes       -        array of uint in a storage buffer, 4 per view
#ifndef GNO_SHADOW_MAP_FIT_GLSL
#define GNO_SHADOW_MAP_FIT_GLSL
#include "project.glsl"
#ifndef GNO_LIGHT
#error "shadow_map/fit.glsl: define GNO_LIGHT"
#endif
#ifndef GNO_SHADOW_MAP_VIEW_COUNT
#error "shadow_map/fit.glsl: define GNO_SHADOW_MAP_VIEW_COUNT or include shadow_map/bindings.glsl before this file"
#endif
#ifndef GNO_SHADOW_MAP_LOAD_VIEW
#error "shadow_map/fit.glsl: define GNO_SHADOW_MAP_LOAD_VIEW(index) or include shadow_map/bindings.glsl before this file"
#endif
#ifndef GNO_SHADOW_MAP_BOUNDS
#error "shadow_map/fit.glsl: define GNO_SHADOW_MAP_BOUNDS or include shadow_map/bindings.glsl before this file"
#endif

void gnoShadowMapMeasure(GnoViewSample s_) {
    vec3 q_ = gnoFromLight(GNO_LIGHT, s_.position);
    for (uint i_ = 0u; i_ < GNO_SHADOW_MAP_VIEW_COUNT; ++i_) {
        vec4 clip_ = gnoShadowMapClip(GNO_SHADOW_MAP_LOAD_VIEW(i_), q_);
        if (!gnoShadowMapHolds(clip_)) continue;
        uint x_ = uint((clip_.x / clip_.w * 0.5f + 0.5f) * GNO_SHADOW_MAP_STEPS);
        uint y_ = uint((clip_.y / clip_.w * 0.5f + 0.5f) * GNO_SHADOW_MAP_STEPS);
        uint steps_ = uint(GNO_SHADOW_MAP_STEPS);
        atomicMax(GNO_SHADOW_MAP_BOUNDS[4u * i_], steps_ - x_ + 1u);
        atomicMax(GNO_SHADOW_MAP_BOUNDS[4u * i_ + 1u], x_ + 1u);
        atomicMax(GNO_SHADOW_MAP_BOUNDS[4u * i_ + 2u], steps_ - y_ + 1u);
        atomicMax(GNO_SHADOW_MAP_BOUNDS[4u * i_ + 3u], y_ + 1u);
        return;
    }
}
#endif
