// SPDX-License-Identifier: MIT
// gnomon top/visit.glsl : what one node of a TOP tree says about a point; shared by the three queries, not for use alone.
//
// Outside the band (plane.glsl) a plane's fp32 sign is certain: it routes, and it is the owner's decision. Inside the band
//   certified      the exact sign of the owner's plane at p does both: lateral zero goes negative (the volume is closed), cap zero positive (in
//   shadow is strictly
//                  behind). Casters that touch the plane are filed by it (build.glsl). A sample's own caster never shadows it: at its cap the point
//                  goes positive.
//                  In the band of a substitute plane (plane.glsl, 8) only the intersection child is left; the owner of such a plane is decided
//                  exactly behind its cap.
//   conservative   in a lateral band the point lies in no volume of the positive or the negative child (their margin is wider): the owner's volume
//   is decided in fp32
//                  at the caster (core/decide.glsl), then only the intersection child is left. In the cap's band the positive child is left as well:
//                  the cap does not pass through the light, casters in front of it do shadow points on it.
//   published      has no band: the fp32 sign routes, zero goes negative, the sample's own caster is like any other.
//
// Space      as the queries
// Stages     any; no barrier, no shared memory, may diverge
// Requires   #version 450, no extension, no optional device feature
//
// Macro                        required  default                  meaning
// GNO_TOP_STATE                yes       -                        uint: gnoState(GNO_PRECISION) where there is a tree to ask (core/state.h)
// GNO_TOP_LOAD_NODE(index)     yes       -                        GnoTopNode at index; index < node count, never GNO_TOP_NONE; no side effect
// GNO_TOP_LOAD_ANCESTOR(index) yes       -                        ancestor link of the volume that node index belongs to
// GNO_TOP_LOAD_FLAGS(index)    yes       -                        aux of the third node of the volume that node index belongs to (node.h)
// GNO_TOP_LOAD_SLAB(index)     no        -                        GnoTopSlab at index, where the tree was built with slabs: children that cannot
//                                                                 matter are not loaded
// GNO_TOP_SLAB                 no        1                        with GNO_TOP_LOAD_SLAB: 0: do not look at it; may be a specialization constant
// GNO_TOP_ROOT                 no        0u                       index of the root; GNO_TOP_NONE means an empty tree: everything is lit
// GNO_TOP_FIND_ROOT(q)         no        GNO_TOP_ROOT             the root of the tree to ask for a point q = gnoFromLight(p), where there are
//                                                                 several; or GNO_TOP_IN_SHADOW
// GNO_TOP_NODE_COUNT           no        -                        nodes that there are; looked at with GNO_DEBUG 1 (core/debug.glsl)
// GNO_TOP_CASTER_OF(block)     no        (block)                  the caster of nodes 4 * block and on
// GNO_LIGHT                    yes       -                        vec4, homogeneous (core/light.glsl)
// GNO_LOAD_CASTER(index)       yes       -                        GnoCaster, on the scene grid
// GNO_PRECISION                no        GNO_PRECISION_CERTIFIED  rung of the ladder; the one the tree was built with
// GNO_TOP_DEPTH_TEST           no        1                        1: skip subtrees that lie farther from the light than the point; 0: visit them
#ifndef GNO_TOP_VISIT_GLSL
#define GNO_TOP_VISIT_GLSL
#include "../core/counters.glsl"
#include "../core/debug.glsl"
#include "../core/decide.glsl"
#include "plane.glsl"
#define GNO_TOP_INCLUDED_
#ifdef GNO_FOREST_UNDECIDED_
#error "top/visit.glsl: forest is bound: define GNO_FOREST_TREES, 1 (its trees) or 0 (one tree), before forest/bindings.glsl"
#endif
#if !defined(GNO_TOP_LOAD_NODE) || !defined(GNO_TOP_LOAD_ANCESTOR) || !defined(GNO_TOP_LOAD_FLAGS)
#error "top/visit.glsl: define GNO_TOP_LOAD_NODE(index), GNO_TOP_LOAD_ANCESTOR(index) and GNO_TOP_LOAD_FLAGS(index) (or include bindings.glsl)"
#endif
#ifndef GNO_LIGHT
#error "top/visit.glsl: define GNO_LIGHT, a homogeneous vec4"
#endif
#ifndef GNO_LOAD_CASTER
#error "top/visit.glsl: define GNO_LOAD_CASTER(index) or include core/bindings.glsl before this file"
#endif
#ifndef GNO_TOP_STATE
#error "top/visit.glsl: define GNO_TOP_STATE, the word of the structure's header (core/state.h), or include bindings.glsl before this file"
#endif
#ifndef GNO_TOP_ROOT
#define GNO_TOP_ROOT 0u
#endif
#ifndef GNO_TOP_FIND_ROOT
#define GNO_TOP_FIND_ROOT(q_) GNO_TOP_ROOT
#endif
#ifndef GNO_TOP_SLAB
#define GNO_TOP_SLAB 1
#endif
#ifdef GNO_TOP_LOAD_SLAB
#define GNO_TOP_SLAB_ GNO_TOP_SLAB
#define GNO_TOP_LOAD_SLAB_(index_) GNO_TOP_LOAD_SLAB(index_)
#else
#define GNO_TOP_SLAB_ 0
#define GNO_TOP_LOAD_SLAB_(index_) gnoTopNoSlab_()
#endif
#ifndef GNO_TOP_CASTER_OF
#define GNO_TOP_CASTER_OF(block_) (block_)
#endif
#ifdef GNO_TOP_NODE_COUNT
#define GNO_TOP_INSIDE_(index_, end_) GNO_DEBUG_INSIDE_(index_, GNO_TOP_NODE_COUNT, end_)
#else
#define GNO_TOP_INSIDE_(index_, end_)
#endif
#ifndef GNO_PRECISION
#define GNO_PRECISION GNO_PRECISION_CERTIFIED
#endif
#ifndef GNO_TOP_DEPTH_TEST
#define GNO_TOP_DEPTH_TEST 1
#endif
GNO_NAMESPACE_BEGIN

struct GnoTopPoint_ {  // a view sample, seen from the light
    vec3 position;
    uint own;
    vec3 q;
    float scale;
    float depth;
};

GNO_INLINE GnoTopPoint_ gnoTopPoint_(GnoViewSample s_) {
    GnoTopPoint_ point_;
    point_.position = s_.position;
    point_.own = s_.own;
    point_.q = gnoFromLight(GNO_LIGHT, s_.position);
    point_.scale = gnoLightScale(GNO_LIGHT, point_.q);
    point_.depth = gnoLightDepth(GNO_LIGHT, point_.q);
    return point_;
}

GNO_INLINE GnoTopSlab gnoTopNoSlab_() {
    GnoTopSlab none_;
    none_.positive = none_.negative = none_.positiveDepth = none_.intersectionDepth = 0u;
    return none_;
}

// The whole subtree lies farther from the light than the point. Only a volume's first node knows.
GNO_INLINE bool gnoTopFarther_(GnoTopPoint_ point_, GnoTopNode node_, uint index_) {
    if (GNO_TOP_SLAB_ != 0) return false;  // the parent knew
    return GNO_TOP_DEPTH_TEST != 0 && (index_ & 3u) == 0u && point_.depth < uintBitsToFloat(node_.aux);
}

GNO_INLINE bool gnoTopMeetsIntersection_(GnoTopPoint_ point_, GnoTopNode node_, GnoTopSlab slab_, uint index_, float side_) {
    if (node_.intersectionChild == GNO_TOP_NONE) return false;
    bool meets_ = (index_ & 3u) == 3u || gnoTopInWedge(node_.wedge, side_, point_.scale, GNO_PRECISION);
    if (GNO_TOP_SLAB_ != 0 && GNO_TOP_DEPTH_TEST != 0 && point_.depth < uintBitsToFloat(slab_.intersectionDepth)) meets_ = false;
    return meets_;
}

// The exact side of a point in the band: 1 positive, -1 negative, 0 on the plane.
GNO_INLINE int gnoTopExactSide_(GnoTopPoint_ point_, uint index_, uint flags_) {
    GnoCaster t_ = GNO_LOAD_CASTER(GNO_TOP_CASTER_OF(index_ >> 2));
    uint place_ = index_ & 3u;
    vec4 origin_ = place_ == 3u ? vec4(t_.a, 1.0f) : GNO_LIGHT;  // orient3d(a, b, c, p), or orient3d(light, a, b, p) and its rotations
    vec3 first_ = place_ == 0u ? t_.a : place_ == 2u ? t_.c : t_.b;
    vec3 second_ = place_ == 0u ? t_.b : place_ == 2u ? t_.a : t_.c;
    GNO_COUNT(exactCalls, 1u);
    int sign_ = gnoOrient3dLight(origin_, first_, second_, point_.position);
    return (flags_ & 3u) == 2u ? -sign_ : sign_;
}

// The next node apart from the intersection child, as the plane says: GNO_TOP_NONE when there is none, GNO_TOP_IN_SHADOW when the search is over.
GNO_INLINE uint gnoTopRouted_(GnoTopPoint_ point_, GnoTopNode node_, uint index_, float side_) {
    bool cap_ = (index_ & 3u) == 3u;
    if (GNO_PRECISION == GNO_PRECISION_PUBLISHED) {
        if (side_ > 0.0f) return node_.positiveChild;
        return cap_ ? GNO_TOP_IN_SHADOW : index_ + 1u;
    }
    bool uncertain_ = abs(side_) <= gnoTopBand(GNO_LIGHT, cap_, point_.scale, cap_ ? uintBitsToFloat(node_.aux) : 0.0f);
    if (cap_ && (uncertain_ || side_ < 0.0f) && GNO_TOP_CASTER_OF(index_ >> 2) == point_.own) return node_.positiveChild;
    if (GNO_PRECISION == GNO_PRECISION_CERTIFIED && (uncertain_ || (cap_ && side_ < 0.0f))) {
        uint place_ = index_ & 3u;
        uint flags_ = GNO_TOP_LOAD_FLAGS(index_);
        if (!cap_ && (flags_ & (GNO_TOP_SUBSTITUTE << place_)) != 0u) return GNO_TOP_NONE;
        // What is to be asked: this plane where it is uncertain; behind a cap with substitute planes before it, all three lateral ones.
        uint asked_ = cap_ && (flags_ & GNO_TOP_SUBSTITUTES) != 0u ? 0u : place_;
        uint end_ = uncertain_ ? place_ + 1u : place_;
        bool positive_ = false;
        for (; asked_ < end_ && !positive_; ++asked_) {
            int exact_ = gnoTopExactSide_(point_, (index_ & ~3u) + asked_, flags_);
            positive_ = asked_ == 3u ? exact_ >= 0 : exact_ > 0;
        }
        if (positive_) return node_.positiveChild;
        return cap_ ? GNO_TOP_IN_SHADOW : index_ + 1u;
    }
    if (uncertain_) {
        uint owner_ = GNO_TOP_CASTER_OF(index_ >> 2);
        if (owner_ != point_.own) {
            GNO_COUNT(exactCalls, 1u);
            if (gnoDecideInShadow(GNO_LIGHT, GNO_LOAD_CASTER(owner_), point_.position, GNO_PRECISION)) return GNO_TOP_IN_SHADOW;
        }
        return cap_ ? node_.positiveChild : GNO_TOP_NONE;
    }
    if (side_ > 0.0f) return node_.positiveChild;
    return cap_ ? GNO_TOP_IN_SHADOW : index_ + 1u;
}

// The same, less what the bounds exclude.
GNO_INLINE uint gnoTopNext_(GnoTopPoint_ point_, GnoTopNode node_, GnoTopSlab slab_, uint index_, float side_) {
    uint next_ = gnoTopRouted_(point_, node_, index_, side_);
    if (GNO_TOP_SLAB_ != 0 && next_ < GNO_TOP_IN_SHADOW) {
        if (next_ == index_ + 1u && (index_ & 3u) != 3u) {  // a cap's positive child may well be the next block
            if (-side_ > uintBitsToFloat(slab_.negative) * point_.scale) return GNO_TOP_NONE;
        } else {
            if (GNO_TOP_DEPTH_TEST != 0 && point_.depth < uintBitsToFloat(slab_.positiveDepth)) return GNO_TOP_NONE;
            if ((index_ & 3u) != 3u && !gnoTopInPositive(slab_.positive, side_, point_.scale)) return GNO_TOP_NONE;
        }
    }
    return next_;
}

// One visit of a node: by all queries. The intersection child is to be visited first, then the one that gnoTopAfter_ tells.
struct GnoTopVisit_ {
    GnoTopNode node;
    GnoTopSlab slab;
    float side;
    bool farther;       // nothing in the subtree matters
    uint intersection;  // GNO_TOP_NONE: none, or it was visited already
};

// `twice`: back from the intersection child.
GNO_INLINE GnoTopVisit_ gnoTopVisit_(GnoTopPoint_ point_, uint index_, bool twice_) {
    GnoTopVisit_ visit_;
    visit_.node = GNO_TOP_LOAD_NODE(index_);
    visit_.slab = gnoTopNoSlab_();
    // here, not where it is asked for: a load of few invocations costs as much as one of all
    if (GNO_TOP_SLAB_ != 0) visit_.slab = GNO_TOP_LOAD_SLAB_(index_);
    GNO_COUNT(visitedNodes, 1u);
    visit_.side = 0.0f;
    visit_.intersection = GNO_TOP_NONE;
    visit_.farther = !twice_ && gnoTopFarther_(point_, visit_.node, index_);
    if (!visit_.farther) {
        visit_.side = gnoTopSide(visit_.node.plane, point_.q);
        if (!twice_ && gnoTopMeetsIntersection_(point_, visit_.node, visit_.slab, index_, visit_.side))
            visit_.intersection = visit_.node.intersectionChild;
    }
    return visit_;
}

// As gnoTopNext_.
GNO_INLINE uint gnoTopAfter_(GnoTopPoint_ point_, GnoTopVisit_ visit_, uint index_) {
    uint next_ = GNO_TOP_NONE;
    if (!visit_.farther) next_ = gnoTopNext_(point_, visit_.node, visit_.slab, index_, visit_.side);
    return next_;
}

GNO_NAMESPACE_END
#endif
