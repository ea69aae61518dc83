// SPDX-License-Identifier: MIT
// gnomon shadow_map/bindings.glsl : our buffers of a shadow map's views; leave it out and define the macros yourself where your storage differs.
//
// Defines    GNO_SHADOW_MAP_STATE, GNO_SHADOW_MAP_VIEW_COUNT, GNO_SHADOW_MAP_SIZE, GNO_SHADOW_MAP_LOAD_VIEW, and with GNO_SHADOW_MAP_MEASURES 1
//            GNO_SHADOW_MAP_BOUNDS
// Space      as view.h
// Stages     any with storage buffers; only a shader that measures writes
// Requires   #version 450, no extension
//
// Macro                            required  default  meaning
// GNO_SHADOW_MAP_SET               no        1        descriptor set
// GNO_SHADOW_MAP_BINDING_VIEWS     no        0        std430: GnoShadowMapHeader, GnoShadowMapView[]
// GNO_SHADOW_MAP_BINDING_BOUNDS    no        1        std430: uint[4 views]
// GNO_SHADOW_MAP_MEASURES          no        0        1: the shader includes fit.glsl
#ifdef GNO_SHADOW_MAP_BINDINGS_GLSL
#error "shadow_map/bindings.glsl: a second inclusion changes nothing: GNO_SHADOW_MAP_SET and the other numbers are read once"
#endif
#ifndef GNO_SHADOW_MAP_BINDINGS_GLSL
#define GNO_SHADOW_MAP_BINDINGS_GLSL
#include "view.h"
#ifndef GNO_SHADOW_MAP_SET
#define GNO_SHADOW_MAP_SET 1
#endif
#ifndef GNO_SHADOW_MAP_BINDING_VIEWS
#define GNO_SHADOW_MAP_BINDING_VIEWS 0
#endif
#ifndef GNO_SHADOW_MAP_BINDING_BOUNDS
#define GNO_SHADOW_MAP_BINDING_BOUNDS 1
#endif
#ifndef GNO_SHADOW_MAP_MEASURES
#define GNO_SHADOW_MAP_MEASURES 0
#endif

layout(set = GNO_SHADOW_MAP_SET, binding = GNO_SHADOW_MAP_BINDING_VIEWS, std430) readonly buffer GnoShadowMapViewBuffer {
    GnoShadowMapHeader header;
    GnoShadowMapView v[];
}
gnoShadowMapViews;
#define GNO_SHADOW_MAP_STATE gnoShadowMapViews.header.state
#define GNO_SHADOW_MAP_VIEW_COUNT gnoShadowMapViews.header.viewCount
#define GNO_SHADOW_MAP_SIZE gnoShadowMapViews.header.size
#define GNO_SHADOW_MAP_LOAD_VIEW(index_) gnoShadowMapViews.v[index_]
#if GNO_SHADOW_MAP_MEASURES
layout(set = GNO_SHADOW_MAP_SET, binding = GNO_SHADOW_MAP_BINDING_BOUNDS, std430) buffer GnoShadowMapBoundsBuffer { uint v[]; }
gnoShadowMapBounds;
#define GNO_SHADOW_MAP_BOUNDS gnoShadowMapBounds.v
#endif
#endif
