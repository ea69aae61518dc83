// SPDX-License-Identifier: MIT
// gnomon clusters/build.glsl : the hierarchy over the view samples, built by one work group per tile and then level by level.
// After Sintorn et al., I3D 2014, sections 2 ("Building the acceleration structure"), 2.1 and 2.3.
//
//   void  gnoClusterReset(uint index, uint count)         dispatch 1, invocation `index` of `count`: empties header, masks and shade
//   void  gnoClusterMeasureDepth(GnoViewSample s, uint invocation)          dispatch 2, all invocations of a work group of any size: depths of its
//   view samples
//   float gnoClusterSliceAt(uint slice)                   dispatch 3: the table's entry for slice 0 .. slices, to be stored in GNO_CLUSTER_SLICES
//   void  gnoClusterAddTile(uvec2 tile, uint invocation, GnoViewSample s, uint what)       one work group per tile, one invocation per pixel of it,
//   row by row
//   void  gnoClusterUp(uint depth, uint key, uint what)   for depth = levels - 1 down to 1, a dispatch each: one invocation per node of that depth
//   void  gnoClusterAllocate(uint word)                   compact only: one invocation per word; gives its children a place in the list
//
// `what` is a sum of GNO_CLUSTER_MASKS_OF_NODES and GNO_CLUSTER_BOUNDS_OF_NODES. Dispatches 4 and on, by form:
//   implicit          tiles (masks), up (masks)
//   explicit, flat    tiles (both), up (both)
//   compact           tiles (masks), up (masks), allocate, tiles (bounds), up (bounds)
//
// The paper updates bounds upwards by atomics in two steps; here a node's bounds are the union of its children's, which are complete because a level
// is a dispatch, so there is no contention and no atomic but the bits of the masks. A cluster has all its samples in one tile: its bounds are made
// in shared memory. The compact form keeps a pointer per word, not per node: a child's box is found by its rank among its siblings. Words that find
// the list full have no boxes, and their children (and whoever needs a bound over these) fall back to the implicit one: the answer stays right, and
// header.boxCount says how long the list should be.
//
// Space      positions on the scene grid
// Stages     compute; gnoClusterMeasureDepth and gnoClusterAddTile hold barriers: all invocations of the work group call them, once
// Requires   #version 450, no extension
// Writes     header, masks, shade, low, high, pointers
// Cost       one atomic per cluster and node; 1 KiB of shared memory
//
// Macro                        required  default                   meaning
// GNO_CLUSTER_BUILDS           no        1                         which functions this shader has: GNO_CLUSTER_PASS_RESET, .._RANGE, .._SLICES,
//                                                                  .._TILES, .._UP, .._ALLOCATE; several with |, 1 for all; bindings.glsl makes
//                                                                  writable what they write
// GNO_CLUSTER_HEADER           yes       -                         GnoClusterHeader in a storage buffer
// GNO_CLUSTER_SHADE            yes       -                         array of uint, gnoClusterShadeWords
// The macros of nodes.glsl
#ifndef GNO_CLUSTERS_BUILD_GLSL
#define GNO_CLUSTERS_BUILD_GLSL
#include "bounds.glsl"
#include "nodes.glsl"
#ifndef GNO_CLUSTER_BUILDS
#define GNO_CLUSTER_BUILDS 1
#endif
#if (GNO_CLUSTER_BUILDS) == 0
#error "clusters/build.glsl: which pass is this? define GNO_CLUSTER_BUILDS before clusters/bindings.glsl, as clusters/cluster.h says"
#endif
#if !defined(GNO_CLUSTER_HEADER) || !defined(GNO_CLUSTER_SHADE)
#error "clusters/build.glsl: define GNO_CLUSTER_HEADER and GNO_CLUSTER_SHADE or include clusters/bindings.glsl before this file"
#endif

const uint GNO_CLUSTER_MASKS_OF_NODES = 1u;
const uint GNO_CLUSTER_BOUNDS_OF_NODES = 2u;

shared uint gnoClusterShared_[64];
shared vec3 gnoClusterPositions_[64];
shared uint gnoClusterLeast_;
shared uint gnoClusterLargest_;
shared uint gnoClusterSlack_;

#if (GNO_CLUSTER_BUILDS) & (1 | GNO_CLUSTER_PASS_RESET)
void gnoClusterReset(uint index_, uint count_) {
    if (index_ == 0u) {
        GNO_CLUSTER_HEADER.leastDepth = 0xFFFFFFFFu;
        GNO_CLUSTER_HEADER.largestDepth = 0u;
        GNO_CLUSTER_HEADER.slack = 0u;
        GNO_CLUSTER_HEADER.boxCount = 0u;
        GNO_CLUSTER_HEADER.nextCaster = 0u;
        GNO_CLUSTER_HEADER.nextJob = 0u;
        GNO_CLUSTER_HEADER.jobCount = 0u;
        GNO_CLUSTER_HEADER.groups = uvec4(0u, 1u, 1u, 0u);
        GNO_CLUSTER_HEADER.tiles = 0u;
        GNO_CLUSTER_HEADER.levels = 0u;
        GNO_CLUSTER_HEADER.state = gnoState(GNO_STATE_ANY);
    }
    uint words_ = gnoClusterWordCount(GNO_CLUSTER_LAYOUT);
    for (uint i_ = index_; i_ < words_; i_ += count_) GNO_CLUSTER_MASKS[i_] = 0u;
    uint shade_ = gnoClusterShadeWords(GNO_CLUSTER_LAYOUT);
    for (uint i_ = index_; i_ < shade_; i_ += count_) GNO_CLUSTER_SHADE[i_] = 0u;
}
#endif

#if (GNO_CLUSTER_BUILDS) & (1 | GNO_CLUSTER_PASS_RANGE)
void gnoClusterMeasureDepth(GnoViewSample s_, uint invocation_) {
    if (invocation_ == 0u) {
        gnoClusterLeast_ = 0xFFFFFFFFu;
        gnoClusterLargest_ = 0u;
    }
    barrier();
    if (s_.own <= GNO_NO_CASTER) {
        uint depth_ = gnoClusterOrdered(gnoClusterDepth(GNO_CLUSTER_FRAME, s_.position));
        atomicMin(gnoClusterLeast_, depth_);
        atomicMax(gnoClusterLargest_, depth_);
    }
    barrier();
    if (invocation_ == 0u && gnoClusterLargest_ != 0u) {
        atomicMin(GNO_CLUSTER_HEADER.leastDepth, gnoClusterLeast_);
        atomicMax(GNO_CLUSTER_HEADER.largestDepth, gnoClusterLargest_);
    }
}
#endif

float gnoClusterSliceAt(uint slice_) {
    float least_ = gnoClusterFromOrdered(GNO_CLUSTER_HEADER.leastDepth);
    float largest_ = gnoClusterFromOrdered(GNO_CLUSTER_HEADER.largestDepth);
    if (slice_ == 0u) GNO_CLUSTER_HEADER.levels = 1u;
    return gnoClusterSliceStart(GNO_CLUSTER_FRAME, GNO_CLUSTER_LAYOUT, least_, largest_, slice_);
}

#if (GNO_CLUSTER_BUILDS) & (1 | GNO_CLUSTER_PASS_TILES | GNO_CLUSTER_PASS_UP)
void gnoClusterStoreBox_(uint index_, vec3 low_, vec3 high_) {
    uint at_ = 3u * index_;
    GNO_CLUSTER_LOW[at_] = low_.x;
    GNO_CLUSTER_LOW[at_ + 1u] = low_.y;
    GNO_CLUSTER_LOW[at_ + 2u] = low_.z;
    GNO_CLUSTER_HIGH[at_] = high_.x;
    GNO_CLUSTER_HIGH[at_ + 1u] = high_.y;
    GNO_CLUSTER_HIGH[at_ + 2u] = high_.z;
}

// Sets the bit of the node at `depth` in its parent's word.
void gnoClusterMark_(uint depth_, uint key_) {
    atomicOr(GNO_CLUSTER_MASKS[gnoClusterWord(GNO_CLUSTER_LAYOUT, depth_ - 1u, key_ >> 5u)], 1u << (key_ & 31u));
}
#endif

#if (GNO_CLUSTER_BUILDS) & (1 | GNO_CLUSTER_PASS_TILES)
void gnoClusterAddTile(uvec2 tile_, uint invocation_, GnoViewSample s_, uint what_) {
    if (invocation_ == 0u) gnoClusterSlack_ = 0u;
    bool there_ = s_.own <= GNO_NO_CASTER;
    float depth_ = gnoClusterDepth(GNO_CLUSTER_FRAME, s_.position);
    uint key_ = there_ ? gnoClusterLeafKey(tile_, depth_) : GNO_CLUSTER_NONE;  // no key: they have at most 29 bits
    gnoClusterShared_[invocation_] = key_;
    gnoClusterPositions_[invocation_] = GNO_CLUSTER_FORM == GNO_CLUSTER_FLAT ? vec3(depth_) : s_.position;
    barrier();
    if (there_ && (what_ & GNO_CLUSTER_MASKS_OF_NODES) != 0u) {
        vec2 from_ = gnoClusterSlope(GNO_CLUSTER_FRAME, gnoClusterTilePixel(GNO_CLUSTER_FORM, tile_, 0u));
        vec2 to_ = gnoClusterSlope(GNO_CLUSTER_FRAME, gnoClusterTilePixel(GNO_CLUSTER_FORM, tile_ + uvec2(1u), 0u));
        atomicMax(gnoClusterSlack_, floatBitsToUint(gnoClusterOutside(GNO_CLUSTER_FRAME, s_.position, from_, to_)));
    }
    uint count_ = GNO_CLUSTER_FORM == GNO_CLUSTER_FLAT ? 32u : 64u;
    bool first_ = there_;  // the first invocation of a cluster speaks for it
    for (uint i_ = 0u; i_ < invocation_ && first_; ++i_) first_ = gnoClusterShared_[i_] != key_;
    if (first_) {
        if ((what_ & GNO_CLUSTER_MASKS_OF_NODES) != 0u) gnoClusterMark_(GNO_CLUSTER_LAYOUT.levels, key_);
        uint box_ = (what_ & GNO_CLUSTER_BOUNDS_OF_NODES) != 0u ? gnoClusterBoxIndex(GNO_CLUSTER_LAYOUT.levels, key_) : GNO_CLUSTER_NONE;
        if (box_ != GNO_CLUSTER_NONE) {
            vec3 low_ = gnoClusterPositions_[invocation_];
            vec3 high_ = low_;
            for (uint i_ = invocation_ + 1u; i_ < count_; ++i_) {
                if (gnoClusterShared_[i_] == key_) {
                    low_ = min(low_, gnoClusterPositions_[i_]);
                    high_ = max(high_, gnoClusterPositions_[i_]);
                }
            }
            if (GNO_CLUSTER_FORM == GNO_CLUSTER_FLAT) {
                GNO_CLUSTER_LOW[box_] = low_.x;
                GNO_CLUSTER_HIGH[box_] = high_.x;
            } else {
                gnoClusterStoreBox_(box_, low_, high_);
            }
        }
    }
    barrier();
    if (invocation_ == 0u) {
        if (gnoClusterSlack_ != 0u) atomicMax(GNO_CLUSTER_HEADER.slack, gnoClusterSlack_);
        atomicAdd(GNO_CLUSTER_HEADER.tiles, uint(bitCount(what_)));
    }
}
#endif

#if (GNO_CLUSTER_BUILDS) & (1 | GNO_CLUSTER_PASS_UP)
// Low above high: a node without bounds of its own.
void gnoClusterUp(uint depth_, uint key_, uint what_) {
    if (key_ == 0u)  // one invocation of the dispatch
        GNO_CLUSTER_HEADER.levels |= ((what_ & GNO_CLUSTER_MASKS_OF_NODES) != 0u ? 1u << depth_ : 0u) |
                                     ((what_ & GNO_CLUSTER_BOUNDS_OF_NODES) != 0u ? 256u << depth_ : 0u);
    uint mask_ = GNO_CLUSTER_MASKS[gnoClusterWord(GNO_CLUSTER_LAYOUT, depth_, key_)];
    if (mask_ == 0u) return;
    if ((what_ & GNO_CLUSTER_MASKS_OF_NODES) != 0u) gnoClusterMark_(depth_, key_);
    if ((what_ & GNO_CLUSTER_BOUNDS_OF_NODES) == 0u) return;
    uint box_ = gnoClusterBoxIndex(depth_, key_);
    if (box_ == GNO_CLUSTER_NONE) return;
    vec3 low_ = vec3(4.0f);
    vec3 high_ = vec3(-4.0f);
    bool known_ = true;
    if (GNO_CLUSTER_FORM == GNO_CLUSTER_FLAT) {
        low_ = vec3(1e30f);
        high_ = vec3(-1e30f);
    }
    for (; mask_ != 0u && known_; mask_ &= mask_ - 1u) {
        uint child_ = gnoClusterBoxIndex(depth_ + 1u, (key_ << 5u) | uint(findLSB(mask_)));
        if (child_ == GNO_CLUSTER_NONE) {
            known_ = false;
        } else if (GNO_CLUSTER_FORM == GNO_CLUSTER_FLAT) {
            low_.x = min(low_.x, GNO_CLUSTER_LOW[child_]);
            high_.x = max(high_.x, GNO_CLUSTER_HIGH[child_]);
        } else {
            vec3 childLow_ = gnoClusterLow_(child_);
            vec3 childHigh_ = gnoClusterHigh_(child_);
            known_ = childLow_.x <= childHigh_.x;
            low_ = min(low_, childLow_);
            high_ = max(high_, childHigh_);
        }
    }
    if (GNO_CLUSTER_FORM == GNO_CLUSTER_FLAT) {
        GNO_CLUSTER_LOW[box_] = low_.x;
        GNO_CLUSTER_HIGH[box_] = high_.x;
    } else {
        gnoClusterStoreBox_(box_, known_ ? low_ : vec3(1.0f), known_ ? high_ : vec3(-1.0f));
    }
}
#endif

#if (GNO_CLUSTER_BUILDS) & (1 | GNO_CLUSTER_PASS_ALLOCATE)
void gnoClusterAllocate(uint word_) {
    uint mask_ = GNO_CLUSTER_MASKS[word_];
    if (mask_ == 0u) return;
    uint count_ = uint(bitCount(mask_));
    uint first_ = atomicAdd(GNO_CLUSTER_HEADER.boxCount, count_);
    bool fits_ = first_ + count_ <= GNO_CLUSTER_FRAME.boxCapacity && first_ + count_ >= first_;
    GNO_CLUSTER_POINTERS[word_] = uvec2(fits_ ? first_ : GNO_CLUSTER_NONE, mask_);
}
#endif
#endif
