// SPDX-License-Identifier: MIT
// gnomon top/query_stack.glsl : is a point inside a shadow volume stored in a TOP tree? With a stack of intersection children.
// After Mora et al., EGSR 2016, algorithm 1 (PSV), and section 3.3 (D-PSV: GNO_TOP_DEPTH_TEST 1).
//
//   uint gnoTopStackAnswer(GnoViewSample s)     GNO_VISIBILITY_LIT, _SHADOW, or _UNKNOWN: there is no tree to ask, none was
//   bool gnoTopQueryStack(GnoViewSample s)      the same for two answers: true where it is not lit
//
// A full stack is counted and never written past. `published` loses the child that found it full, as the paper's does; the other rungs
// then ask again without a stack when the search ends without a shadow, so nothing is lost.
//
// Space      s.position on the scene grid, s.own the caster it lies on or GNO_NO_CASTER
// Sides      visit.glsl
// Stages     any; no barrier, no shared memory, may diverge
// Requires   #version 450, no extension, no optional device feature
// Reads      nodes through GNO_TOP_LOAD_NODE, casters through GNO_LOAD_CASTER; writes nothing; declares no binding
// Cost       one node load per visited node, GNO_TOP_STACK_SIZE words of private memory
//
// Macro                        required  default  meaning
// GNO_TOP_STACK_SIZE           no        32       entries; may be a specialization constant; at least 1
// The macros of visit.glsl     yes       -        nodes, casters, light, precision, depth test
#ifndef GNO_TOP_QUERY_STACK_GLSL
#define GNO_TOP_QUERY_STACK_GLSL
#include "query_stackless.glsl"
#ifndef GNO_TOP_STACK_SIZE
#define GNO_TOP_STACK_SIZE 32
#endif
GNO_NAMESPACE_BEGIN

GNO_INLINE uint gnoTopStackAnswer(GnoViewSample s_) {
    if (GNO_TOP_STATE != gnoState(GNO_PRECISION)) return GNO_VISIBILITY_UNKNOWN;
    GnoTopPoint_ point_ = gnoTopPoint_(s_);
    uint stack_[GNO_TOP_STACK_SIZE];
    uint used_ = 0u;
    bool lost_ = false;
    uint index_ = GNO_TOP_FIND_ROOT(point_.q);
    if (index_ == GNO_TOP_IN_SHADOW) return GNO_VISIBILITY_SHADOW;
    GNO_DEBUG_TURNS_;
    while (index_ != GNO_TOP_NONE) {
        GNO_DEBUG_TURN_(return GNO_VISIBILITY_UNKNOWN);
        GNO_TOP_INSIDE_(index_, return GNO_VISIBILITY_UNKNOWN);
        GnoTopVisit_ visit_ = gnoTopVisit_(point_, index_, false);
        if (visit_.intersection != GNO_TOP_NONE) {
            if (used_ < uint(GNO_TOP_STACK_SIZE)) {
                stack_[used_] = visit_.intersection;
                ++used_;
                GNO_COUNT_MAX(deepestStack, used_);
            } else {
                lost_ = true;
                GNO_COUNT(stackOverflows, 1u);
            }
        }
        uint next_ = gnoTopAfter_(point_, visit_, index_);
        if (next_ == GNO_TOP_IN_SHADOW) return GNO_VISIBILITY_SHADOW;
        if (next_ == GNO_TOP_NONE && used_ > 0u) {
            --used_;
            next_ = stack_[used_];
        }
        index_ = next_;
    }
    if (lost_ && GNO_PRECISION != GNO_PRECISION_PUBLISHED) return gnoTopStacklessAnswer(s_);
    return GNO_VISIBILITY_LIT;
}

GNO_INLINE bool gnoTopQueryStack(GnoViewSample s_) { return gnoTopStackAnswer(s_) != GNO_VISIBILITY_LIT; }

GNO_NAMESPACE_END
#endif
