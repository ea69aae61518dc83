// SPDX-License-Identifier: MIT
// gnomon top/query_stackless.glsl : is a point inside a shadow volume stored in a TOP tree? Without a stack.
// After Mora et al., EGSR 2016, algorithm 3 (D-Stackless): the intersection child first, then back by the ancestor link.
//
//   uint gnoTopStacklessAnswer(GnoViewSample s)     GNO_VISIBILITY_LIT, _SHADOW, or _UNKNOWN: there is no tree to ask, none was
//   bool gnoTopQueryStackless(GnoViewSample s)      the same for two answers: true where it is not lit
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

GNO_INLINE uint gnoTopStacklessAnswer(GnoViewSample s_) {
    if (GNO_TOP_STATE != gnoState(GNO_PRECISION)) return GNO_VISIBILITY_UNKNOWN;
    GnoTopPoint_ point_ = gnoTopPoint_(s_);
    bool twice_ = false;  // this node's intersection child was visited already
    uint index_ = GNO_TOP_FIND_ROOT(point_.q);
    if (index_ == GNO_TOP_IN_SHADOW) return GNO_VISIBILITY_SHADOW;
    GNO_DEBUG_TURNS_;
    while (index_ != GNO_TOP_NONE) {
        GNO_DEBUG_TURN_(return GNO_VISIBILITY_UNKNOWN);
        GNO_TOP_INSIDE_(index_, return GNO_VISIBILITY_UNKNOWN);
        GnoTopVisit_ visit_ = gnoTopVisit_(point_, index_, twice_);
        if (visit_.intersection != GNO_TOP_NONE) {
            index_ = visit_.intersection;
            continue;
        }
        uint next_ = gnoTopAfter_(point_, visit_, index_);
        if (next_ == GNO_TOP_IN_SHADOW) return GNO_VISIBILITY_SHADOW;
        twice_ = next_ == GNO_TOP_NONE;
        if (twice_) next_ = GNO_TOP_LOAD_ANCESTOR(index_);
        index_ = next_;
    }
    return GNO_VISIBILITY_LIT;
}

GNO_INLINE bool gnoTopQueryStackless(GnoViewSample s_) { return gnoTopStacklessAnswer(s_) != GNO_VISIBILITY_LIT; }

GNO_NAMESPACE_END
#endif
