// SPDX-License-Identifier: MIT
// gnomon rivals/light_bvh_query.glsl : is a point in shadow? Asked of a light-space hierarchy (rivals/light_bvh_build.glsl).
//
//   uint gnoLightBvhAnswer(GnoViewSample s)           GNO_VISIBILITY_LIT, _SHADOW, or _UNKNOWN: there is no hierarchy to ask, none was. With a stack
//   uint gnoLightBvhStacklessAnswer(GnoViewSample s)  the same by the parents' links
//   bool gnoLightBvhQuery(GnoViewSample s)            gnoLightBvhAnswer for two answers: true where it is not lit
//   bool gnoLightBvhQueryStackless(GnoViewSample s)   the same of the other
//
// Both go down from the root of the sample's face, into children that hold the sample's cell and do not lie farther from the light than it, and stop
// at the first caster that shadows it. Cells are compared as integers and a child's least depth is a lower bound, so only casters that certainly do
// not shadow the sample are left out.
// A leaf's caster is decided by core/decide.glsl: `certified` by its filtered exact signs, `conservative` in fp32. The sample's own caster is
// passed.
// A full stack is counted and never written past: the query then starts again without a stack, so nothing is lost.
//
// Space      s.position on the scene grid, s.own the caster it lies on or GNO_NO_CASTER
// Stages     any; no barrier, no shared memory, may diverge
// Requires   #version 450, no extension, no optional device feature
// Reads      header (roots), nodes, casters; stackless: parents too; writes nothing; declares no binding
// Cost       a load of 64 bytes per visited node, of a caster per leaf. visitedNodes counts both, exactCalls the casters
//
// Macro                             required  default                  meaning
// GNO_LIGHT_BVH_GRID                yes       -                        GnoForestGrid, resolution GNO_LIGHT_BVH_RESOLUTION
// GNO_LIGHT_BVH_STATE               yes       -                        uint: gnoState(GNO_STATE_ANY) where there is a hierarchy (core/state.h)
// GNO_LIGHT_BVH_ROOT(face)          yes       -                        uint, GNO_LIGHT_BVH_NONE: no caster on that face
// GNO_LIGHT_BVH_LOAD_NODE(index)    yes       -                        GnoLightBvhNode
// GNO_LIGHT_BVH_LOAD_PARENT(index)  yes       -                        uint: 4 * parent + place among its children, GNO_LIGHT_BVH_NONE for a root
// GNO_LIGHT                         yes       -                        vec4, homogeneous (core/light.glsl)
// GNO_LOAD_CASTER(index)            yes       -                        GnoCaster, on the scene grid
// GNO_PRECISION                     no        GNO_PRECISION_CERTIFIED  rung of the ladder, GNO_PRECISION_CONSERVATIVE or above
// GNO_LIGHT_BVH_STACK_SIZE          no        32                       entries; may be a specialization constant; at least 1
#ifndef GNO_RIVALS_LIGHT_BVH_QUERY_GLSL
#define GNO_RIVALS_LIGHT_BVH_QUERY_GLSL
#include "../core/counters.glsl"
#include "../core/debug.glsl"
#include "../core/decide.glsl"
#include "light_bvh_bounds.glsl"
#ifndef GNO_LIGHT_BVH_STATE
#error "rivals/light_bvh_query.glsl: define GNO_LIGHT_BVH_STATE (or include light_bvh_bindings.glsl)"
#endif
#if !defined(GNO_LIGHT_BVH_GRID) || !defined(GNO_LIGHT_BVH_ROOT)
#error "rivals/light_bvh_query.glsl: define GNO_LIGHT_BVH_GRID and GNO_LIGHT_BVH_ROOT(face) (or include light_bvh_bindings.glsl)"
#endif
#if !defined(GNO_LIGHT_BVH_LOAD_NODE) || !defined(GNO_LIGHT_BVH_LOAD_PARENT)
#error "rivals/light_bvh_query.glsl: define GNO_LIGHT_BVH_LOAD_NODE(index) and GNO_LIGHT_BVH_LOAD_PARENT(index) (or include light_bvh_bindings.glsl)"
#endif
#ifndef GNO_LIGHT
#error "rivals/light_bvh_query.glsl: define GNO_LIGHT, a homogeneous vec4"
#endif
#ifndef GNO_LOAD_CASTER
#error "rivals/light_bvh_query.glsl: define GNO_LOAD_CASTER(index) or include core/bindings.glsl before this file"
#endif
#ifndef GNO_PRECISION
#define GNO_PRECISION GNO_PRECISION_CERTIFIED
#endif
#ifndef GNO_LIGHT_BVH_STACK_SIZE
#define GNO_LIGHT_BVH_STACK_SIZE 32
#endif

bool gnoLightBvhShadows_(uint leaf_, GnoViewSample s_) {
    uint caster_ = leaf_ & GNO_LIGHT_BVH_CASTER;
    if (caster_ == s_.own) return false;
    GNO_COUNT(visitedNodes, 1u);
    GNO_COUNT(exactCalls, 1u);
    GnoCaster t_ = GNO_LOAD_CASTER(caster_);
    if (GNO_PRECISION == GNO_PRECISION_CERTIFIED)
        return gnoInShadowOfFacing(GNO_LIGHT, t_, s_.position, (leaf_ & GNO_LIGHT_BVH_POSITIVE) != 0u ? 1 : -1);
    return gnoDecideInShadow(GNO_LIGHT, t_, s_.position, GNO_PRECISION);
}

// Bit c: child c holds the cell, and something in it is no farther from the light than `depth`.
uint gnoLightBvhMet_(GnoLightBvhNode node_, uint place_, float depth_) {
    uint met_ = 0u;
    for (uint c_ = 0u; c_ < 4u; ++c_) {
        if (gnoLightBvhHolds(node_.low[c_], node_.high[c_], place_) && node_.least[c_] <= depth_) met_ |= 1u << c_;
    }
    return met_;
}

uint gnoLightBvhStacklessAnswer(GnoViewSample s_) {
    if (GNO_LIGHT_BVH_STATE != gnoState(GNO_STATE_ANY)) return GNO_VISIBILITY_UNKNOWN;
    vec3 q_ = gnoFromLight(GNO_LIGHT, s_.position);
    uvec3 at_ = gnoCellAt(GNO_LIGHT, GNO_LIGHT_BVH_GRID, q_);
    uint place_ = at_.x | (at_.y << 16);
    float depth_ = gnoLightDepth(GNO_LIGHT, q_);
    uint index_ = GNO_LIGHT_BVH_ROOT(at_.z);
    uint from_ = 0u;  // children below this one are done
    GNO_DEBUG_TURNS_;
    while (index_ != GNO_LIGHT_BVH_NONE) {
        GNO_DEBUG_TURN_(return GNO_VISIBILITY_UNKNOWN);
        GnoLightBvhNode node_ = GNO_LIGHT_BVH_LOAD_NODE(index_);
        GNO_COUNT(visitedNodes, 1u);
        uint met_ = gnoLightBvhMet_(node_, place_, depth_) & (0xFu << from_);
        uint down_ = GNO_LIGHT_BVH_NONE;
        while (met_ != 0u && down_ == GNO_LIGHT_BVH_NONE) {
            int child_ = findLSB(met_);
            met_ &= met_ - 1u;
            uint link_ = node_.link[child_];
            if ((link_ & GNO_LIGHT_BVH_LEAF) == 0u) down_ = link_;
            else if (gnoLightBvhShadows_(link_, s_)) return GNO_VISIBILITY_SHADOW;
        }
        if (down_ != GNO_LIGHT_BVH_NONE) {
            index_ = down_;
            from_ = 0u;
        } else {
            uint parent_ = GNO_LIGHT_BVH_LOAD_PARENT(index_);
            index_ = parent_ == GNO_LIGHT_BVH_NONE ? GNO_LIGHT_BVH_NONE : parent_ >> 2;
            from_ = (parent_ & 3u) + 1u;
        }
    }
    return GNO_VISIBILITY_LIT;
}

uint gnoLightBvhAnswer(GnoViewSample s_) {
    if (GNO_LIGHT_BVH_STATE != gnoState(GNO_STATE_ANY)) return GNO_VISIBILITY_UNKNOWN;
    vec3 q_ = gnoFromLight(GNO_LIGHT, s_.position);
    uvec3 at_ = gnoCellAt(GNO_LIGHT, GNO_LIGHT_BVH_GRID, q_);
    uint place_ = at_.x | (at_.y << 16);
    float depth_ = gnoLightDepth(GNO_LIGHT, q_);
    uint stack_[GNO_LIGHT_BVH_STACK_SIZE];
    uint used_ = 0u;
    bool lost_ = false;
    uint link_ = GNO_LIGHT_BVH_ROOT(at_.z);
    GNO_DEBUG_TURNS_;
    while (link_ != GNO_LIGHT_BVH_NONE) {
        while ((link_ & GNO_LIGHT_BVH_LEAF) == 0u) {  // invocations that found a leaf wait for the others, and all decide at once
            GNO_DEBUG_TURN_(return GNO_VISIBILITY_UNKNOWN);
            GnoLightBvhNode node_ = GNO_LIGHT_BVH_LOAD_NODE(link_);
            GNO_COUNT(visitedNodes, 1u);
            uint met_ = gnoLightBvhMet_(node_, place_, depth_);
            link_ = GNO_LIGHT_BVH_NONE;
            for (uint c_ = 0u; c_ < 4u; ++c_) {
                if ((met_ & (1u << c_)) == 0u) continue;
                if (link_ != GNO_LIGHT_BVH_NONE) {
                    if (used_ < uint(GNO_LIGHT_BVH_STACK_SIZE)) {
                        stack_[used_] = link_;
                        ++used_;
                        GNO_COUNT_MAX(deepestStack, used_);
                    } else {
                        lost_ = true;
                        GNO_COUNT(stackOverflows, 1u);
                    }
                }
                link_ = node_.link[c_];
            }
            if (link_ == GNO_LIGHT_BVH_NONE && used_ > 0u) link_ = stack_[--used_];
        }
        if (link_ == GNO_LIGHT_BVH_NONE) break;
        if (gnoLightBvhShadows_(link_, s_)) return GNO_VISIBILITY_SHADOW;
        link_ = used_ > 0u ? stack_[--used_] : GNO_LIGHT_BVH_NONE;
    }
    if (lost_) return gnoLightBvhStacklessAnswer(s_);
    return GNO_VISIBILITY_LIT;
}

bool gnoLightBvhQuery(GnoViewSample s_) { return gnoLightBvhAnswer(s_) != GNO_VISIBILITY_LIT; }

bool gnoLightBvhQueryStackless(GnoViewSample s_) { return gnoLightBvhStacklessAnswer(s_) != GNO_VISIBILITY_LIT; }
#endif
