// SPDX-License-Identifier: MIT
// gnomon rivals/light_grid_query.glsl : is a point in the shadow of a caster of its cell's list?
//
//   uint gnoLightGridAnswer(GnoViewSample s)     GNO_VISIBILITY_LIT, _SHADOW, or _UNKNOWN: there are no lists to ask, none was
//   bool gnoLightGridQuery(GnoViewSample s)      the same for two answers: true where it is not lit
//
// A sample in a closed cell can be shadowed only by casters whose volumes meet it, and by none that begins beyond it: the list holds the first
// (forest/cells.glsl, 1 to 5), in order of a lower bound of their depths (top/plane.glsl, 7), so the walk ends at the first that begins beyond. Each
// caster before it is decided by the definition itself (certified; core/orient3d.glsl), or by the same signs in fp32 (conservative;
// core/decide.glsl). The sample's own caster never shadows it. With GNO_LIGHT_GRID_PLANES its four planes are asked first, and the definition only
// in their bands (top/plane.glsl, 2, 4 and 5; nothing is routed by them, so no margin is needed).
//
// Space      s.position on the scene grid, s.own the caster it lies on or GNO_NO_CASTER
// Stages     any; no barrier, no shared memory, may diverge
// Requires   #version 450, no extension
// Reads      lists and items, casters through GNO_LOAD_CASTER; writes nothing; declares no binding
// Cost       one load per item looked at and one per caster decided, both counted as visited nodes
//
// Macro                     required  default                  meaning
// GNO_LIGHT_GRID_STATE      yes       -                        uint: gnoState(GNO_STATE_ANY) where there are lists to ask (core/state.h)
// GNO_LIGHT_GRID_LISTS      yes       -                        array of GnoLightGridList
// GNO_LIGHT_GRID_ITEMS      yes       -                        array of GnoLightGridItem, sorted
// GNO_LIGHT_GRID_FIRST_LIST no        0u                       where the lists that are asked begin; those of several lights may lie in one array
// GNO_LIGHT_GRID_FIRST_ITEM no        0u                       the same for items
// GNO_LIGHT_GRID_CAPACITY   no        -                        items that there are; looked at with GNO_DEBUG 1 (core/debug.glsl)
// GNO_FOREST_GRID           yes       -                        GnoForestGrid
// GNO_LIGHT                 yes       -                        vec4, homogeneous (core/light.glsl)
// GNO_LOAD_CASTER(index)    yes       -                        GnoCaster, on the scene grid
// GNO_PRECISION             no        GNO_PRECISION_CERTIFIED  certified or conservative
// GNO_LIGHT_GRID_PLANES     no        0                        1: casters have planes, the four of gnoLightGridPlanes (light_grid_planes.glsl)
// GNO_LIGHT_GRID_LOAD_PLANE(index)  no  -                      vec4, index = 4 * caster + 0 .. 3; needed with GNO_LIGHT_GRID_PLANES
#ifndef GNO_RIVALS_LIGHT_GRID_QUERY_GLSL
#define GNO_RIVALS_LIGHT_GRID_QUERY_GLSL
#include "../core/counters.glsl"
#include "../core/debug.glsl"
#include "../core/decide.glsl"
#include "light_grid_place.glsl"
#include "light_grid_planes.glsl"
#ifndef GNO_LIGHT_GRID_STATE
#error "rivals/light_grid_query.glsl: define GNO_LIGHT_GRID_STATE (or include light_grid_bindings.glsl)"
#endif
#if !defined(GNO_LIGHT_GRID_LISTS) || !defined(GNO_LIGHT_GRID_ITEMS)
#error "rivals/light_grid_query.glsl: define GNO_LIGHT_GRID_LISTS and GNO_LIGHT_GRID_ITEMS (or include light_grid_bindings.glsl)"
#endif
#ifndef GNO_FOREST_GRID
#error "rivals/light_grid_query.glsl: define GNO_FOREST_GRID or include forest/bindings.glsl before this file"
#endif
#ifndef GNO_LIGHT
#error "rivals/light_grid_query.glsl: define GNO_LIGHT, a homogeneous vec4"
#endif
#ifndef GNO_LOAD_CASTER
#error "rivals/light_grid_query.glsl: define GNO_LOAD_CASTER(index) or include core/bindings.glsl before this file"
#endif
#ifndef GNO_PRECISION
#define GNO_PRECISION GNO_PRECISION_CERTIFIED
#endif
#ifdef GNO_LIGHT_GRID_CAPACITY
#define GNO_LIGHT_GRID_INSIDE_(index_, end_) GNO_DEBUG_INSIDE_(index_, GNO_LIGHT_GRID_CAPACITY, end_)
#else
#define GNO_LIGHT_GRID_INSIDE_(index_, end_)
#endif
#ifndef GNO_LIGHT_GRID_FIRST_LIST
#define GNO_LIGHT_GRID_FIRST_LIST 0u
#endif
#ifndef GNO_LIGHT_GRID_FIRST_ITEM
#define GNO_LIGHT_GRID_FIRST_ITEM 0u
#endif
#ifndef GNO_LIGHT_GRID_PLANES
#define GNO_LIGHT_GRID_PLANES 0
#endif

bool gnoLightGridShadows_(GnoViewSample s_, vec3 q_, float scale_, GnoLightGridItem item_) {
    uint caster_ = item_.caster & ~GNO_LIGHT_GRID_FRONT;
    if (caster_ == s_.own) return false;
#if GNO_LIGHT_GRID_PLANES
    vec4 ab_ = GNO_LIGHT_GRID_LOAD_PLANE(4u * caster_);
    GNO_COUNT(visitedNodes, 1u);
    float band_ = gnoTopBand(GNO_LIGHT, false, scale_, 0.0f);
    float most_ = gnoLightGridSide(GNO_LIGHT, ab_, q_);
    if (most_ > band_) return false;
    most_ = max(most_, gnoLightGridSide(GNO_LIGHT, GNO_LIGHT_GRID_LOAD_PLANE(4u * caster_ + 1u), q_));
    if (most_ > band_) return false;
    most_ = max(most_, gnoLightGridSide(GNO_LIGHT, GNO_LIGHT_GRID_LOAD_PLANE(4u * caster_ + 2u), q_));
    if (most_ > band_) return false;
    float cap_ = gnoTopSide(GNO_LIGHT_GRID_LOAD_PLANE(4u * caster_ + 3u), q_);
    float capBand_ = gnoTopBand(GNO_LIGHT, true, scale_, gnoLightGridReach(GNO_LIGHT, ab_));
    if (cap_ > capBand_) return false;
    if (most_ < -band_ && cap_ < -capBand_) return true;
#endif
    GnoCaster t_ = GNO_LOAD_CASTER(caster_);
    GNO_COUNT(visitedNodes, 1u);
    GNO_COUNT(exactCalls, 1u);
    if (GNO_PRECISION != GNO_PRECISION_CERTIFIED) return gnoDecideInShadow(GNO_LIGHT, t_, s_.position, GNO_PRECISION);
    return gnoInShadowOfFacing(GNO_LIGHT, t_, s_.position, caster_ == item_.caster ? -1 : 1);
}

uint gnoLightGridAnswer(GnoViewSample s_) {
    if (GNO_LIGHT_GRID_STATE != gnoState(GNO_STATE_ANY)) return GNO_VISIBILITY_UNKNOWN;
    vec3 q_ = gnoFromLight(GNO_LIGHT, s_.position);
    float depth_ = gnoLightDepth(GNO_LIGHT, q_);
    float scale_ = gnoLightScale(GNO_LIGHT, q_);
    uvec2 place_ = gnoLightGridPlace(GNO_LIGHT, GNO_FOREST_GRID, q_);
    GnoLightGridList list_ = GNO_LIGHT_GRID_LISTS[GNO_LIGHT_GRID_FIRST_LIST + place_.x];
    if (list_.end == GNO_LIGHT_GRID_NESTED) list_ = GNO_LIGHT_GRID_LISTS[GNO_LIGHT_GRID_FIRST_LIST + list_.first + place_.y];
    GNO_DEBUG_TURNS_;
    for (uint i_ = list_.first; i_ < list_.end; ++i_) {
        GNO_DEBUG_TURN_(return GNO_VISIBILITY_UNKNOWN);
        GNO_LIGHT_GRID_INSIDE_(GNO_LIGHT_GRID_FIRST_ITEM + i_, return GNO_VISIBILITY_UNKNOWN);
        GnoLightGridItem item_ = GNO_LIGHT_GRID_ITEMS[GNO_LIGHT_GRID_FIRST_ITEM + i_];
        GNO_COUNT(visitedNodes, 1u);
        if (depth_ < uintBitsToFloat(item_.depth)) return GNO_VISIBILITY_LIT;
        if (gnoLightGridShadows_(s_, q_, scale_, item_)) return GNO_VISIBILITY_SHADOW;
    }
    return GNO_VISIBILITY_LIT;
}

bool gnoLightGridQuery(GnoViewSample s_) { return gnoLightGridAnswer(s_) != GNO_VISIBILITY_LIT; }
#endif
