// SPDX-License-Identifier: MIT
// gnomon top/query_stackless.glsl : is a point inside a shadow volume stored in a TOP tree? Without a stack.
// After Mora et al., EGSR 2016, algorithm 3 (D-Stackless): the intersection child first, then back by the ancestor link.
//
//   bool gnoTopQueryStackless(GnoViewSample s)      true: s is in shadow
//
// Space      s.position on the scene grid, s.own the caster it lies on or GNO_NO_CASTER
// Sides      visit.glsl
// Stages     any; no barrier, no shared memory, may diverge
// Requires   #version 450, no extension, no optional device feature
// Reads      nodes through GNO_TOP_LOAD_NODE, casters through GNO_LOAD_CASTER; writes nothing; declares no binding
// Cost       one node load per visited node; a node whose intersection child was visited is loaded twice; no stack
//
// Macro                        required  default  meaning
// The macros of visit.glsl     yes       -        nodes, casters, light, precision, depth test
#ifndef GNO_TOP_QUERY_STACKLESS_GLSL
#define GNO_TOP_QUERY_STACKLESS_GLSL
#include "visit.glsl"
GNO_NAMESPACE_BEGIN

GNO_INLINE bool gnoTopQueryStackless(GnoViewSample s_) {
    GnoTopPoint_ point_ = gnoTopPoint_(s_);
    bool twice_ = false;  // this node's intersection child was visited already
    uint index_ = GNO_TOP_FIND_ROOT(point_.q);
    if (index_ == GNO_TOP_IN_SHADOW) return true;
    while (index_ != GNO_TOP_NONE) {
        GnoTopNode node_ = GNO_TOP_LOAD_NODE(index_);
        GnoTopSlab slab_ = gnoTopNoSlab_();
        // here, not where it is asked for: a load of few invocations costs as much as one of all
        if (GNO_TOP_SLAB_ != 0) slab_ = GNO_TOP_LOAD_SLAB_(index_);
        GNO_COUNT(visitedNodes, 1u);
        uint next_ = GNO_TOP_NONE;
        if (twice_ || !gnoTopFarther_(point_, node_, index_)) {
            float side_ = gnoTopSide(node_.plane, point_.q);
            if (!twice_ && gnoTopMeetsIntersection_(point_, node_, slab_, index_, side_)) {
                index_ = node_.intersectionChild;
                continue;
            }
            twice_ = false;
            next_ = gnoTopNext_(point_, node_, slab_, index_, side_);
            if (next_ == GNO_TOP_IN_SHADOW) return true;
        }
        if (next_ == GNO_TOP_NONE) {
            next_ = GNO_TOP_LOAD_ANCESTOR(index_);
            twice_ = true;
        }
        index_ = next_;
    }
    return false;
}

GNO_NAMESPACE_END
#endif
