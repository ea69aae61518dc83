// SPDX-License-Identifier: MIT
// gnomon top/build.glsl : a TOP tree over shadow volumes, built by one invocation per caster without locks and without fences.
// After Mora et al., EGSR 2016, algorithm 2 (depth and ancestor links included); margins and bounds as in plane.glsl.
//
//   void gnoTopBegin(uint casterCount, uint state)   dispatch 1, one invocation: an empty tree that so many insertions make whole; state as below
//   void gnoTopSetUp(uint block, int facing)         dispatch 1: writes a caster's planes and empty links; facing 0: it is left out
//   bool gnoTopInsert(uint block)                    dispatch 2: files the caster; false: left out, or inside another volume and not needed
//
// A block is four nodes, 4 * block and on. Here block b is caster b's; where a caster stands in several trees (glsl/forest) it has a block in each.
//
// Dispatch 1 writes all that never changes. Dispatch 2 touches links only by relaxed atomics: a compare-and-swap takes an empty child or tells
// who has it. Planes and links are published by the dispatch boundary, so no acquire or release is needed, on any device.
// For a balanced tree call gnoTopInsert(gnoPermute(i, n, seed)) for i = 0 .. n - 1 (core/permutation.glsl): once for each block, the left out, too.
//
// The header tells a query whether there is a tree to ask (core/state.h). gnoTopBegin gets gnoState(GNO_PRECISION), or another word where something
// that it needs is missing: then nothing is inserted and no query answers. An insertion without such a word, or one more than casterCount, does
// nothing: without a set-up before it, links hold what the last build left, and the way through them need not end.
//
// What differs from the paper, but for `published`:
// - Margins (plane.glsl): a caster goes to one side only when its whole volume certainly does.
// - A cap has no intersection child. A point that is not in the owner's shadow would visit both it and the positive child, always; one subtree is
// cheaper than two.
// - Touching (`certified`). A caster's vertex that is also an end point of the plane's own edge (cap: a vertex of the owner) lies on the plane
//   exactly; it counts as neither side, so a neighbour in a mesh goes to the side of its other vertices instead of to the intersection child. The
//   queries then route by the exact sign of the owner's plane inside the band: lateral zero goes negative, cap zero positive (visit.glsl). This is
//   safe. Let p be in the volume of a caster T in the
//   - lateral, positive child: p is a sum of T's vertices with weights >= 0, their exact sides are > 0 or, touching, 0. If p's is > 0, p is routed
//     to T. If it is 0, p lies in the cone over touching vertices alone: beyond a point x of the owner's own edge, strictly, because p is strictly
//     behind T. x belongs to the owner, p is in the owner's closed cone and strictly behind it: the owner shadows p, and the negative route finds
//     it. (A sample that lies on the owner is in front of it, never behind x.)
//   - lateral, negative child: p's exact side is <= 0, and p is routed there.
//   - cap, dropped T: T is in the owner's closed cone, its vertices are behind the cap or on it; p = L + sum l_i (v_i - L) with sum l_i > 1
//     (strictly behind T) and the light is in front, so p's side is < 0: the owner shadows p. The same holds towards infinity.
//
// Space      casters on the scene grid; facing = gnoFacing(light, caster), exact
// Stages     any with storage buffers; no barrier, no shared memory, may diverge
// Requires   #version 450, no extension
// Reads      casters, planes; dispatch 2 reads links and slabs by atomics only, but for what dispatch 1 alone writes
// Writes     planes where they are kept, links, header; slabs where there are any
// Cost       20 steps per caster and an atomic per step, about (random order, 100,000 casters); one more atomic per caster
//
// With GNO_TOP_STORE_PLANES 0 a volume takes 64 bytes, not 128: its links. Each step then computes the node's plane anew from its owner's vertices
// and flags (gnoTopPlane in plane.glsl), with the same bits, so it is the same tree.
//
// Macro                     required  default                   meaning
// GNO_TOP_BUILDS            no        1                         which of the two functions this shader has, GNO_TOP_PASS_SET_UP or
//                                                               .._BUILD, or 1 for both; bindings.glsl makes writable what they write
// GNO_TOP_PLANES            yes       -                         array of vec4, 4 per caster; not where GNO_TOP_STORE_PLANES is 0
// GNO_TOP_STORE_PLANES      no        1                         0: planes are not kept, the queries have to compute them as well; may be a
//                                                               specialization constant where
//                                                               there is GNO_TOP_PLANES, which then is left alone
// GNO_TOP_LINKS             yes       -                         array of GnoTopLink in a storage buffer, 4 per caster
// GNO_TOP_HEADER            yes       -                         GnoTopHeader in a storage buffer; its root is unused where GNO_TOP_ROOT_OF is given
// GNO_TOP_SLABS             no        -                         array of GnoTopSlab in a storage buffer, 4 per caster: bounds of the children, for
//                                                               the queries; not for `published`
// GNO_TOP_SLAB              no        1                         with GNO_TOP_SLABS: 0: leave it alone; may be a specialization constant
// GNO_TOP_ROOT_OF(block)    no        GNO_TOP_HEADER.root       uint in a storage buffer: the root of the tree that block belongs to
// GNO_TOP_CASTER_OF(block)  no        (block)                   the caster of a block
// GNO_TOP_NODE_COUNT        no        -                         nodes that there are; looked at with GNO_DEBUG 1 (core/debug.glsl)
// GNO_LIGHT                 yes       -                         vec4, homogeneous (core/light.glsl)
// GNO_LOAD_CASTER(index)    yes       -                         GnoCaster
// GNO_PRECISION             no        GNO_PRECISION_CERTIFIED   rung of the ladder; the queries must use the same
#ifndef GNO_TOP_BUILD_GLSL
#define GNO_TOP_BUILD_GLSL
#include "../core/counters.glsl"
#include "../core/debug.glsl"
#include "plane.glsl"
#define GNO_TOP_INCLUDED_
#ifdef GNO_FOREST_UNDECIDED_
#error "top/build.glsl: forest is bound: define GNO_FOREST_TREES, 1 (its trees) or 0 (one tree), before forest/bindings.glsl"
#endif
#ifndef GNO_TOP_BUILDS
#define GNO_TOP_BUILDS 1
#endif
#if !((GNO_TOP_BUILDS) & (1 | GNO_TOP_PASS_SET_UP | GNO_TOP_PASS_BUILD))
#error "top/build.glsl: which pass is this? define GNO_TOP_BUILDS before top/bindings.glsl, as top/node.h says"
#endif
#if (GNO_TOP_BUILDS) & (1 | GNO_TOP_PASS_BUILD)
#ifdef GNO_FOREST_ROOTS_READONLY_
#error "top/build.glsl: the roots lie in the forest's cells: define GNO_FOREST_BUILDS, too, as forest/cells.h says"
#endif
#endif
#ifndef GNO_TOP_STORE_PLANES
#define GNO_TOP_STORE_PLANES 1
#endif
#if (!defined(GNO_TOP_PLANES) && GNO_TOP_STORE_PLANES) || !defined(GNO_TOP_LINKS) || !defined(GNO_TOP_HEADER)
#error "top/build.glsl: define GNO_TOP_PLANES, GNO_TOP_LINKS and GNO_TOP_HEADER or include top/bindings.glsl before this file"
#endif
#ifndef GNO_LIGHT
#error "top/build.glsl: define GNO_LIGHT, a homogeneous vec4"
#endif
#ifndef GNO_LOAD_CASTER
#error "top/build.glsl: define GNO_LOAD_CASTER(index) or include core/bindings.glsl before this file"
#endif
#ifndef GNO_TOP_ROOT_OF
#define GNO_TOP_ROOT_OF(block_) GNO_TOP_HEADER.root
#endif
#ifndef GNO_TOP_SLAB
#define GNO_TOP_SLAB 1
#endif
#ifndef GNO_TOP_CASTER_OF
#define GNO_TOP_CASTER_OF(block_) (block_)
#endif
#ifdef GNO_TOP_NODE_COUNT
#define GNO_TOP_BUILT_INSIDE_(index_, end_) GNO_DEBUG_INSIDE_(index_, GNO_TOP_NODE_COUNT, end_)
#else
#define GNO_TOP_BUILT_INSIDE_(index_, end_)
#endif
#ifndef GNO_PRECISION
#define GNO_PRECISION GNO_PRECISION_CERTIFIED
#endif
GNO_NAMESPACE_BEGIN

// A vertex of t that is also an end point of the plane's own edge (cap: a vertex of the owner) lies on the plane exactly, whatever fp32 says.
GNO_INLINE bool gnoTopTouches_(vec3 v_, GnoCaster owner_, uint place_) {
    if (place_ == 3u) return v_ == owner_.a || v_ == owner_.b || v_ == owner_.c;
    vec3 first_ = place_ == 0u ? owner_.a : place_ == 1u ? owner_.b : owner_.c;
    vec3 second_ = place_ == 0u ? owner_.b : place_ == 1u ? owner_.c : owner_.a;
    return v_ == first_ || v_ == second_;
}

#if (GNO_TOP_BUILDS) & (1 | GNO_TOP_PASS_BUILD)
#ifdef GNO_TOP_SLABS
// A caster goes to the positive child: its distance, and (not for a cap) its sides.
GNO_INLINE void gnoTopWidenPositive_(uint node_, vec3 sides_, vec3 scales_, float depth_, float spread_) {
    atomicMin(GNO_TOP_SLABS[node_].positiveDepth, floatBitsToUint(depth_));
    if ((node_ & 3u) == 3u) return;
    uint slab_ = gnoTopPositive(GNO_LIGHT, sides_, scales_, depth_, spread_);
    uint expected_ = 0u;
    GNO_DEBUG_TURNS_;
    for (;;) {
        GNO_DEBUG_TURN_(return);
        uint wider_ = gnoTopWidest(expected_, slab_);
        if (wider_ == expected_) return;
        uint found_ = atomicCompSwap(GNO_TOP_SLABS[node_].positive, expected_, wider_);
        if (found_ == expected_) return;
        expected_ = found_;
    }
}
#endif

// Both bounds of a node only grow; the halves of one word grow together by compare-and-swap.
GNO_INLINE void gnoTopWiden_(uint node_, uint wedge_) {
    if (GNO_PRECISION == GNO_PRECISION_PUBLISHED) {
        atomicMax(GNO_TOP_LINKS[node_].wedge, wedge_);
        return;
    }
    uint expected_ = 0u;
    GNO_DEBUG_TURNS_;
    for (;;) {
        GNO_DEBUG_TURN_(return);
        uint wider_ = gnoTopWidest(expected_, wedge_);
        if (wider_ == expected_) return;
        uint found_ = atomicCompSwap(GNO_TOP_LINKS[node_].wedge, expected_, wider_);
        if (found_ == expected_) return;
        expected_ = found_;
    }
}

#endif

// Of a volume whose flags are written (gnoTopSetUp).
GNO_INLINE vec4 gnoTopPlaneOf_(uint node_) {
#ifdef GNO_TOP_PLANES
    if (GNO_TOP_STORE_PLANES != 0) return GNO_TOP_PLANES[node_];
#endif
    return gnoTopPlane(GNO_LIGHT, GNO_LOAD_CASTER(GNO_TOP_CASTER_OF(node_ >> 2)), node_ & 3u, GNO_TOP_LINKS[(node_ & ~3u) + 2u].aux, GNO_PRECISION);
}

#if (GNO_TOP_BUILDS) & (1 | GNO_TOP_PASS_SET_UP)
GNO_INLINE void gnoTopBegin(uint casterCount_, uint state_) {
    GNO_TOP_HEADER.root = GNO_TOP_NONE;
    GNO_TOP_HEADER.casterCount = casterCount_;
    GNO_TOP_HEADER.state = state_;
    GNO_TOP_HEADER.inserted = 0u;
}

GNO_INLINE void gnoTopSetUp(uint block_, int facing_) {
    uint first_ = 4u * block_;
    GnoCaster t_ = GNO_LOAD_CASTER(GNO_TOP_CASTER_OF(block_));
    for (uint i_ = 0u; i_ < 4u; ++i_) {
        GNO_TOP_LINKS[first_ + i_].positiveChild = GNO_TOP_NONE;
        GNO_TOP_LINKS[first_ + i_].intersectionChild = GNO_TOP_NONE;
        GNO_TOP_LINKS[first_ + i_].wedge = 0u;
    }
    float depth_ = GNO_PRECISION == GNO_PRECISION_PUBLISHED ? gnoTopPublishedDepth(GNO_LIGHT, t_) : gnoTopLeastDepth(GNO_LIGHT, t_);
    float reach_ = max(gnoLightScale(GNO_LIGHT, gnoFromLight(GNO_LIGHT, t_.a)),
                       max(gnoLightScale(GNO_LIGHT, gnoFromLight(GNO_LIGHT, t_.b)), gnoLightScale(GNO_LIGHT, gnoFromLight(GNO_LIGHT, t_.c))));
    GNO_TOP_LINKS[first_].aux = floatBitsToUint(depth_);
    GNO_TOP_LINKS[first_ + 1u].aux = GNO_TOP_NONE;
    GNO_TOP_LINKS[first_ + 3u].aux = floatBitsToUint(reach_);
    uint flags_ = uint(facing_ + 1);
    for (uint place_ = 0u; place_ < 3u; ++place_) {
        vec4 substitute_;
        if (GNO_PRECISION == GNO_PRECISION_CERTIFIED && gnoTopSubstitute(GNO_LIGHT, t_, place_, substitute_)) flags_ |= GNO_TOP_SUBSTITUTE << place_;
    }
    GNO_TOP_LINKS[first_ + 2u].aux = flags_;
#ifdef GNO_TOP_PLANES
    if (GNO_TOP_STORE_PLANES != 0) {
        for (uint i_ = 0u; i_ < 4u; ++i_) GNO_TOP_PLANES[first_ + i_] = gnoTopPlane(GNO_LIGHT, t_, i_, flags_, GNO_PRECISION);
    }
#endif
#ifdef GNO_TOP_SLABS
    if (GNO_TOP_SLAB != 0) {
        vec3 q0_ = gnoFromLight(GNO_LIGHT, t_.a);
        vec3 q1_ = gnoFromLight(GNO_LIGHT, t_.b);
        vec3 q2_ = gnoFromLight(GNO_LIGHT, t_.c);
        vec3 scales_ = vec3(gnoLightScale(GNO_LIGHT, q0_), gnoLightScale(GNO_LIGHT, q1_), gnoLightScale(GNO_LIGHT, q2_));
        float spread_ = gnoTopSpread(GNO_LIGHT, q0_, q1_, q2_);
        for (uint i_ = 0u; i_ < 4u; ++i_) {
            vec4 plane_ = gnoTopPlaneOf_(first_ + i_);
            vec3 sides_ = vec3(gnoTopSide(plane_, q0_), gnoTopSide(plane_, q1_), gnoTopSide(plane_, q2_));
            GNO_TOP_SLABS[first_ + i_].positive = 0u;
            GNO_TOP_SLABS[first_ + i_].negative = floatBitsToUint(gnoTopNegative(GNO_LIGHT, sides_, scales_, depth_, spread_));
            GNO_TOP_SLABS[first_ + i_].positiveDepth = floatBitsToUint(GNO_TOP_NO_BOUND);
            GNO_TOP_SLABS[first_ + i_].intersectionDepth = floatBitsToUint(GNO_TOP_NO_BOUND);
        }
    }
#endif
}
#endif

#if (GNO_TOP_BUILDS) & (1 | GNO_TOP_PASS_BUILD)
GNO_INLINE bool gnoTopInsert(uint block_) {
    if (GNO_TOP_HEADER.state != gnoState(GNO_PRECISION)) return false;  // written in dispatch 1 only
    if (atomicAdd(GNO_TOP_HEADER.inserted, 1u) >= GNO_TOP_HEADER.casterCount) return false;
    uint first_ = 4u * block_;
    if ((GNO_TOP_LINKS[first_ + 2u].aux & 3u) == 1u) return false;  // facing 0: left out; written in dispatch 1 only
    GnoCaster t_ = GNO_LOAD_CASTER(GNO_TOP_CASTER_OF(block_));
    vec3 q0_ = gnoFromLight(GNO_LIGHT, t_.a);
    vec3 q1_ = gnoFromLight(GNO_LIGHT, t_.b);
    vec3 q2_ = gnoFromLight(GNO_LIGHT, t_.c);
    vec3 scales_ = vec3(gnoLightScale(GNO_LIGHT, q0_), gnoLightScale(GNO_LIGHT, q1_), gnoLightScale(GNO_LIGHT, q2_));
    float spread_ = gnoTopSpread(GNO_LIGHT, q0_, q1_, q2_);
    float depth_ = GNO_PRECISION == GNO_PRECISION_PUBLISHED ? gnoTopPublishedDepth(GNO_LIGHT, t_) : gnoTopLeastDepth(GNO_LIGHT, t_);
    uint depthBits_ = floatBitsToUint(depth_);
    uint ancestor_ = GNO_TOP_NONE;

    uint node_ = atomicCompSwap(GNO_TOP_ROOT_OF(block_), GNO_TOP_NONE, first_);
    GNO_DEBUG_TURNS_;
    while (node_ != GNO_TOP_NONE) {
        GNO_DEBUG_TURN_(return false);
        GNO_TOP_BUILT_INSIDE_(node_, return false);
        GNO_COUNT(buildSteps, 1u);
        bool cap_ = (node_ & 3u) == 3u;
#ifdef GNO_TOP_SLABS
        bool slab_ = GNO_TOP_SLAB != 0;
#else
        bool slab_ = false;
#endif
        if ((node_ & 3u) == 0u && !slab_) atomicMin(GNO_TOP_LINKS[node_].aux, depthBits_);
        vec4 plane_ = gnoTopPlaneOf_(node_);
        vec3 sides_ = vec3(gnoTopSide(plane_, q0_), gnoTopSide(plane_, q1_), gnoTopSide(plane_, q2_));
        vec3 margins_ = vec3(0.0f);
        if (GNO_PRECISION != GNO_PRECISION_PUBLISHED) {
            float reach_ = cap_ ? uintBitsToFloat(GNO_TOP_LINKS[node_].aux) : 0.0f;  // a cap's aux is written in dispatch 1 only
            margins_ = vec3(gnoTopMargin(GNO_LIGHT, cap_, scales_.x, reach_), gnoTopMargin(GNO_LIGHT, cap_, scales_.y, reach_),
                            gnoTopMargin(GNO_LIGHT, cap_, scales_.z, reach_));
        }
        bvec3 neither_ = bvec3(false);
        bool near_ = abs(sides_.x) <= margins_.x || abs(sides_.y) <= margins_.y || abs(sides_.z) <= margins_.z;
        if (GNO_PRECISION == GNO_PRECISION_CERTIFIED && near_) {
            uint flags_ = GNO_TOP_LINKS[(node_ & ~3u) + 2u].aux;  // written in dispatch 1 only
            if ((flags_ & (GNO_TOP_SUBSTITUTE << (node_ & 3u))) == 0u) {
                GnoCaster owner_ = GNO_LOAD_CASTER(GNO_TOP_CASTER_OF(node_ >> 2));
                neither_ = bvec3(gnoTopTouches_(t_.a, owner_, node_ & 3u), gnoTopTouches_(t_.b, owner_, node_ & 3u),
                                 gnoTopTouches_(t_.c, owner_, node_ & 3u));
                sides_ = vec3(neither_.x ? 0.0f : sides_.x, neither_.y ? 0.0f : sides_.y, neither_.z ? 0.0f : sides_.z);
            }
        }
        bool below_ = (neither_.x || sides_.x < -margins_.x) && (neither_.y || sides_.y < -margins_.y) && (neither_.z || sides_.z < -margins_.z);
        bool above_ = (neither_.x || sides_.x > margins_.x) && (neither_.y || sides_.y > margins_.y) && (neither_.z || sides_.z > margins_.z);
        if (cap_ && GNO_PRECISION != GNO_PRECISION_PUBLISHED) above_ = true;  // one child in front of a cap, not two
        if (below_) {
            bool inside_ = cap_;
            if (cap_ && GNO_PRECISION == GNO_PRECISION_CERTIFIED) inside_ = (GNO_TOP_LINKS[node_ - 1u].aux & GNO_TOP_SUBSTITUTES) == 0u;
            if (inside_) {  // inside another shadow volume: nothing to add
                GNO_COUNT(dropped, 1u);
                return false;
            }
#ifdef GNO_TOP_SLABS
            if (slab_ && cap_) gnoTopWidenPositive_(node_, sides_, scales_, depth_, spread_);
            if (slab_ && !cap_)
                atomicMax(GNO_TOP_SLABS[node_].negative, floatBitsToUint(gnoTopNegative(GNO_LIGHT, sides_, scales_, depth_, spread_)));
#endif
            node_ = cap_ ? atomicCompSwap(GNO_TOP_LINKS[node_].positiveChild, GNO_TOP_NONE, first_) : node_ + 1u;
        } else if (above_) {
#ifdef GNO_TOP_SLABS
            if (slab_) gnoTopWidenPositive_(node_, sides_, scales_, depth_, spread_);
#endif
            node_ = atomicCompSwap(GNO_TOP_LINKS[node_].positiveChild, GNO_TOP_NONE, first_);
        } else {
            GNO_COUNT(intersections, 1u);
            if (!cap_) {  // the capping plane does not pass through the light: it has no wedge
                gnoTopWiden_(node_, gnoTopWedge(GNO_LIGHT, sides_, scales_, depth_, spread_, GNO_PRECISION));
            }
#ifdef GNO_TOP_SLABS
            if (slab_) atomicMin(GNO_TOP_SLABS[node_].intersectionDepth, depthBits_);
#endif
            ancestor_ = node_;
            node_ = atomicCompSwap(GNO_TOP_LINKS[node_].intersectionChild, GNO_TOP_NONE, first_);
        }
    }
    GNO_TOP_LINKS[first_ + 1u].aux = ancestor_;  // nobody reads it before the next dispatch
    return true;
}
#endif

GNO_NAMESPACE_END
#endif
