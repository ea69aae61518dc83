// SPDX-License-Identifier: MIT
// gnomon top/query_hybrid.glsl : is a point inside a shadow volume stored in a TOP tree? With a short stack that cannot overflow.
// After Mora et al., EGSR 2016, section 3.5 (D-Hybrid): an intersection child that finds the stack full is visited at once, without a stack;
// back at its parent by the ancestor link, the query goes on with the stack.
//
//   uint gnoTopHybridAnswer(GnoViewSample s)     GNO_VISIBILITY_LIT, _SHADOW, or _UNKNOWN: there is no tree to ask, none was
//   bool gnoTopQueryHybrid(GnoViewSample s)      the same for two answers: true where it is not lit
//
// Space      s.position on the scene grid, s.own the caster it lies on or GNO_NO_CASTER
// Sides      visit.glsl
// Stages     any; no barrier, no shared memory, may diverge
// Requires   #version 450, no extension, no optional device feature
// Reads      nodes through GNO_TOP_LOAD_NODE, casters through GNO_LOAD_CASTER; writes nothing; declares no binding
// Cost       one node load per visited node, GNO_TOP_SHORT_STACK_SIZE words of private memory
//
// Macro                        required  default  meaning
// GNO_TOP_SHORT_STACK_SIZE     no        12       entries; may be a specialization constant; at least 1
// The macros of visit.glsl     yes       -        nodes, casters, light, precision, depth test
#ifndef GNO_TOP_QUERY_HYBRID_GLSL
#define GNO_TOP_QUERY_HYBRID_GLSL
#include "visit.glsl"
#ifndef GNO_TOP_SHORT_STACK_SIZE
#define GNO_TOP_SHORT_STACK_SIZE 12
#endif
GNO_NAMESPACE_BEGIN

GNO_INLINE uint gnoTopHybridAnswer(GnoViewSample s_) {
    if (GNO_TOP_STATE != gnoState(GNO_PRECISION)) return GNO_VISIBILITY_UNKNOWN;
    GnoTopPoint_ point_ = gnoTopPoint_(s_);
    uint stack_[GNO_TOP_SHORT_STACK_SIZE];
    uint used_ = 0u;
    uint resume_ = GNO_TOP_NONE;  // the node at which the stack takes over again; GNO_TOP_NONE: it is in use
    bool twice_ = false;          // this node's intersection child was visited already
    uint index_ = GNO_TOP_FIND_ROOT(point_.q);
    if (index_ == GNO_TOP_IN_SHADOW) return GNO_VISIBILITY_SHADOW;
    GNO_DEBUG_TURNS_;
    while (index_ != GNO_TOP_NONE) {
        GNO_DEBUG_TURN_(return GNO_VISIBILITY_UNKNOWN);
        GNO_TOP_INSIDE_(index_, return GNO_VISIBILITY_UNKNOWN);
        GnoTopVisit_ visit_ = gnoTopVisit_(point_, index_, twice_);
        if (visit_.intersection != GNO_TOP_NONE) {
            if (resume_ != GNO_TOP_NONE || used_ == uint(GNO_TOP_SHORT_STACK_SIZE)) {
                if (resume_ == GNO_TOP_NONE) {
                    resume_ = index_;
                    GNO_COUNT(stackOverflows, 1u);
                }
                index_ = visit_.intersection;
                continue;
            }
            stack_[used_] = visit_.intersection;
            ++used_;
            GNO_COUNT_MAX(deepestStack, used_);
        }
        uint next_ = gnoTopAfter_(point_, visit_, index_);
        if (next_ == GNO_TOP_IN_SHADOW) return GNO_VISIBILITY_SHADOW;
        twice_ = next_ == GNO_TOP_NONE && resume_ != GNO_TOP_NONE;
        if (twice_) {
            next_ = GNO_TOP_LOAD_ANCESTOR(index_);
            if (next_ == resume_) resume_ = GNO_TOP_NONE;
        } else if (next_ == GNO_TOP_NONE && used_ > 0u) {
            --used_;
            next_ = stack_[used_];
        }
        index_ = next_;
    }
    return GNO_VISIBILITY_LIT;
}

GNO_INLINE bool gnoTopQueryHybrid(GnoViewSample s_) { return gnoTopHybridAnswer(s_) != GNO_VISIBILITY_LIT; }

GNO_NAMESPACE_END
#endif
