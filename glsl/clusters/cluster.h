// SPDX-License-Identifier: MIT
// gnomon clusters/cluster.h : how a hierarchy of view-sample clusters lies in memory; read by glslang and by C++20 (namespace gno).
// After Sintorn, Kämpe, Olsson, Assarsson, "Per-Triangle Shadow Volumes Using a View-Sample Cluster Hierarchy", I3D 2014, section 2 and figure 2,
// and, as the flat form, after Sintorn, Olsson, Assarsson, "An Efficient Alias-free Shadow Algorithm ...", SIGGRAPH Asia 2011.
//
// Space      positions on the scene grid; planes in the coordinates of gnoFromLight (core/light.glsl)
// Stages     any
// Requires   #version 450, no extension
//
//   GnoClusterLayout gnoClusterLayout(uvec2 size, uint form)                follows from resolution and form
//   uint gnoClusterFirstNode(GnoClusterLayout layout, uint depth)           index of the first node at depth 1 .. levels + 1 (there: the number of
//   all nodes but the root)
//   uint gnoClusterWord(GnoClusterLayout layout, uint depth, uint key)      index of the word of inner node `key` at depth 0 .. levels - 1
//   uint gnoClusterWordsAt(GnoClusterLayout layout, uint depth)             words of inner nodes at a depth
//   uint gnoClusterWordCount(GnoClusterLayout layout)                       words of all
//   uint gnoClusterNodeCount(GnoClusterLayout layout)                       nodes without the root
//   uint gnoClusterSlices(GnoClusterLayout layout)                          depth slices
//   uint gnoClusterTileHeight(GnoClusterLayout layout)                      pixels
//   uint gnoClusterShadeWords(GnoClusterLayout layout)                      words of 32 samples in the shade array
//   bool gnoClusterIsBuilt(uint state, uint tiles, uint levels, uint boxCount, GnoClusterLayout layout)      of a header: no pass over the view
//   samples is missing
//   uint gnoClusterState(GnoClusterHeader header, GnoClusterFrame frame, GnoClusterLayout layout)      the word of core/state.h: may it be asked?
//
// A leaf is a CLUSTER: the view samples of one tile of 8x8 pixels in one depth slice. Its key of `bits` bits holds tile x, tile y and slice,
// interleaved from the low end (x lowest); the slices' two extra bits stand on top. A node at depth d (1 .. levels; the root is 0) is named by the
// leading bits of a key: its index among those of its depth. Every node has 32 children (the root 2 to 32), so the tree is an array of 32-bit child
// masks, one WORD per inner node, and a node's index follows from its key.
// The flat form of 2011 has no slices and tiles of 8x4 pixels.
//
//   1024x1024   7 + 7 + 9 = 23 bits   5 levels   words 1, 8, 256, 8192, 262144   8,659,208 nodes          (section 3: 8.65 million)
//   1920x1080   8 + 8 + 10            6 levels                                    69,273,666 nodes
//   8192x8192   10 + 10 + 9           6 levels   (compact: 8) slices are coarser, so that an array of all words stays within a binding of 128 MiB
//
//   array      bytes                     written by                                        read by
//   header     64                        all but merge (tiles, traversal: atomics)         all
//   slices     4 (slices + 1)            slices                                            tiles, traversal (implicit), merge
//   masks      4 words                   reset; tiles, up; traversal (atomics only)        up; traversal (atomics only); merge
//   shade      8 bytes a tile (flat: 4)  reset; traversal (atomics only)                   traversal (atomics only); merge
//   low, high  12 boxes each             tiles, up (flat: 4 nodes each, least and largest depth)  up, traversal
//   pointers   8 words (compact only)    allocate                                          tiles, up, traversal
//   volumes    112 n                     volumes                                           traversal
//   info       8 n                       volumes                                           traversal
//   jobs       8 capacity                expand                                            finish
//
// A shader that builds or traverses says which pass it is, before bindings.glsl: #define GNO_CLUSTER_BUILDS GNO_CLUSTER_PASS_TILES; several with |,
// all: 1.
#ifndef GNO_CLUSTERS_CLUSTER_H
#define GNO_CLUSTERS_CLUSTER_H
#include "../core/state.h"
#define GNO_CLUSTER_PASS_RESET 2      // writes header, masks and shade
#define GNO_CLUSTER_PASS_RANGE 4      // header
#define GNO_CLUSTER_PASS_SLICES 8     // slices, by its caller; header
#define GNO_CLUSTER_PASS_TILES 16     // masks, header, low, high
#define GNO_CLUSTER_PASS_UP 32        // masks, low, high, header
#define GNO_CLUSTER_PASS_ALLOCATE 64  // header, pointers
#define GNO_CLUSTER_PASS_VOLUMES 128  // volumes, info, header
#define GNO_CLUSTER_PASS_EXPAND 256   // masks, shade, jobs, header
#define GNO_CLUSTER_PASS_FINISH 512   // masks, shade, header
#define GNO_CLUSTER_PASS_SIZES 1024   // header, by its caller
GNO_NAMESPACE_BEGIN

// Where a node's bounds come from.
GNO_CONST uint GNO_CLUSTER_IMPLICIT = 0u;  // its key alone
GNO_CONST uint GNO_CLUSTER_EXPLICIT = 1u;  // a box for every node of the full tree
GNO_CONST uint GNO_CLUSTER_COMPACT = 2u;   // boxes of existing nodes only; one pointer per word and the rank of a child among its siblings
GNO_CONST uint GNO_CLUSTER_FLAT = 3u;      // 2011: tile and depth range

GNO_CONST uint GNO_CLUSTER_TILE = 8u;             // pixels
GNO_CONST uint GNO_CLUSTER_FLAT_TILE_HEIGHT = 4u;
GNO_CONST uint GNO_CLUSTER_MOST_BITS = 29u;       // 17.3 million words, 69 MB of masks; compact: one bit less, 69 MB of pointers
GNO_CONST uint GNO_CLUSTER_MOST_LEVELS = 6u;
GNO_CONST uint GNO_CLUSTER_NONE = 0xFFFFFFFFu;    // no boxes for the children of this word

struct GnoClusterLayout {   // std140 and std430, 48 bytes; follows from resolution and form (gnoClusterLayout)
    uint levels;            //  0  1 .. 6
    uint bits;              //  4  of a key
    uint sliceBits;         //  8
    uint form;              // 12  GNO_CLUSTER_IMPLICIT ...
    uvec2 tiles;            // 16  per row, per column
    uint maskX;             // 24  bits of a key that hold tile x
    uint maskY;             // 28
    uint maskZ;             // 32  slice
    uint unused0;           // 36
    uint unused1;           // 40
    uint unused2;           // 44
};
GNO_STRUCT_SIZE(GnoClusterLayout, 48)
GNO_STRUCT_OFFSET(GnoClusterLayout, tiles, 16)
GNO_STRUCT_OFFSET(GnoClusterLayout, maskZ, 32)

struct GnoClusterFrame {    // std140 and std430, 96 bytes
    vec4 origin;            //  0  xyz viewer (orthographic: any point), on the grid; w 1 perspective, 0 orthographic
    vec4 right;             // 16  unit vector along a row of pixels; w: slope of the image's right edge (orthographic: half its width)
    vec4 down;              // 32  unit vector along a column; w: the same of the lower edge
    vec4 forward;           // 48  unit vector along which the viewer looks; w 0
    uvec2 size;             // 64  pixels
    uint casterCount;       // 72
    uint jobCapacity;       // 76  entries of the job list, may be 0
    uint boxCapacity;       // 80  entries of low and high (compact)
    uint split;             // 84  depth at which a traversal stops and leaves a job, 0: never
    uint extraPlanes;       // 88  1: cull by the three extra planes as well
    uint frontCulled;       // 92  1: casters that face the light are left out (`published` then needs no bias)
};
GNO_STRUCT_SIZE(GnoClusterFrame, 96)
GNO_STRUCT_OFFSET(GnoClusterFrame, size, 64)
GNO_STRUCT_OFFSET(GnoClusterFrame, jobCapacity, 76)
GNO_STRUCT_OFFSET(GnoClusterFrame, frontCulled, 92)

struct GnoClusterHeader {   // std430, 64 bytes
    uint leastDepth;        //  0  of the view samples, as an ordered integer (gnoClusterOrdered); atomicMin
    uint largestDepth;      //  4  atomicMax
    uint slack;             //  8  float bits: how far a sample may lie outside its cell, grid units; atomicMax
    uint boxCount;          // 12  boxes that compact needed; more than the capacity: some words have none
    uint nextCaster;        // 16  counter of the first pass's jobs
    uint nextJob;           // 20  of the second pass's
    uint jobCount;          // 24  jobs left for the second pass; more than the capacity: finished in place
    uint state;             // 28  reset: gnoState(GNO_STATE_ANY), core/state.h
    uvec4 groups;           // 32  xyz: arguments of the second pass's indirect dispatch
    uint tiles;             // 48  work groups that put masks, and those that put bounds
    uint levels;            // 52  bits: 0 slices, depth: its masks went up, 8 + depth: its bounds did
    uint volumes;           // 56  volumes: gnoState(precision); they outlive the view samples
    uint unused0;           // 60
};
GNO_STRUCT_SIZE(GnoClusterHeader, 64)
GNO_STRUCT_OFFSET(GnoClusterHeader, state, 28)
GNO_STRUCT_OFFSET(GnoClusterHeader, nextCaster, 16)
GNO_STRUCT_OFFSET(GnoClusterHeader, groups, 32)

// All passes over view samples are done, so volumes may go through the hierarchy.
GNO_INLINE bool gnoClusterIsBuilt(uint state_, uint tiles_, uint levels_, uint boxes_, GnoClusterLayout layout_) {
    bool bounds_ = layout_.form != GNO_CLUSTER_IMPLICIT;
    uint put_ = layout_.tiles.x * layout_.tiles.y * (bounds_ ? 2u : 1u);
    uint up_ = (1u << layout_.levels) - 2u;  // depths 1 .. levels - 1
    uint noted_ = layout_.form == GNO_CLUSTER_FLAT ? levels_ | 1u : levels_;  // it has no slices
    if (state_ != gnoState(GNO_STATE_ANY) || tiles_ != put_ || noted_ != ((bounds_ ? up_ << 8u : 0u) | up_ | 1u)) return false;
    return layout_.form != GNO_CLUSTER_COMPACT || boxes_ != 0u;
}

// The word of core/state.h for the merge: it is built, and all volumes went through it.
GNO_INLINE uint gnoClusterState(GnoClusterHeader header_, GnoClusterFrame frame_, GnoClusterLayout layout_) {
    uint jobs_ = header_.jobCount < frame_.jobCapacity ? header_.jobCount : frame_.jobCapacity;
    bool done_ = header_.nextCaster >= frame_.casterCount && header_.nextJob >= jobs_ && header_.largestDepth != 0u;
    return done_ && gnoClusterIsBuilt(header_.state, header_.tiles, header_.levels, header_.boxCount, layout_) ? header_.state : 0u;
}

GNO_INLINE uint gnoClusterBits_(uint count_) {  // bits that hold 0 .. count - 1
    uint bits_ = 0u;
    while ((1u << bits_) < count_) ++bits_;
    return bits_;
}

// Resolution up to 8192x8192.
GNO_INLINE GnoClusterLayout gnoClusterLayout(uvec2 size_, uint form_) {
    bool flat_ = form_ == GNO_CLUSTER_FLAT;
    uint height_ = flat_ ? GNO_CLUSTER_FLAT_TILE_HEIGHT : GNO_CLUSTER_TILE;
    GnoClusterLayout layout_;
    layout_.form = form_;
    layout_.tiles = uvec2((size_.x + GNO_CLUSTER_TILE - 1u) / GNO_CLUSTER_TILE, (size_.y + height_ - 1u) / height_);
    uint x_ = gnoClusterBits_(layout_.tiles.x);
    uint y_ = gnoClusterBits_(layout_.tiles.y);
    uint z_ = 0u;
    if (!flat_) {
        x_ = x_ > y_ ? x_ : y_;
        y_ = x_;
        z_ = x_ + 2u;
        uint most_ = form_ == GNO_CLUSTER_COMPACT ? GNO_CLUSTER_MOST_BITS - 1u : GNO_CLUSTER_MOST_BITS;
        if (x_ + y_ + z_ > most_) z_ = most_ - x_ - y_;
    }
    layout_.sliceBits = z_;
    layout_.bits = 0u;
    layout_.maskX = 0u;
    layout_.maskY = 0u;
    layout_.maskZ = 0u;
    layout_.unused0 = layout_.unused1 = layout_.unused2 = 0u;
    for (uint i_ = 0u; i_ < 16u; ++i_) {
        if (i_ < x_) layout_.maskX |= 1u << layout_.bits++;
        if (i_ < y_) layout_.maskY |= 1u << layout_.bits++;
        if (i_ < z_) layout_.maskZ |= 1u << layout_.bits++;
    }
    if (layout_.bits == 0u) layout_.bits = 1u;  // one tile: a tree of one word, whose second child never exists
    layout_.levels = (layout_.bits + 4u) / 5u;
    return layout_;
}

// Index of the first node at depth 1 .. levels + 1 (there: the number of all nodes but the root).
GNO_INLINE uint gnoClusterFirstNode(GnoClusterLayout layout_, uint depth_) {
    uint top_ = layout_.bits - 5u * (layout_.levels - 1u);
    uint first_ = 0u;
    uint count_ = 1u << top_;
    for (uint i_ = 1u; i_ < depth_; ++i_) {
        first_ += count_;
        count_ <<= 5u;
    }
    return first_;
}

// Index of the word of inner node `key` at depth 0 .. levels - 1: the root's is 0, any other's follows its node's.
GNO_INLINE uint gnoClusterWord(GnoClusterLayout layout_, uint depth_, uint key_) {
    return depth_ == 0u ? 0u : 1u + gnoClusterFirstNode(layout_, depth_) + key_;
}

// Words of inner nodes at a depth, and of all.
GNO_INLINE uint gnoClusterWordsAt(GnoClusterLayout layout_, uint depth_) {
    return depth_ == 0u ? 1u : 1u << (layout_.bits - 5u * (layout_.levels - depth_));
}
GNO_INLINE uint gnoClusterWordCount(GnoClusterLayout layout_) { return 1u + gnoClusterFirstNode(layout_, layout_.levels); }
GNO_INLINE uint gnoClusterNodeCount(GnoClusterLayout layout_) { return gnoClusterFirstNode(layout_, layout_.levels + 1u); }
GNO_INLINE uint gnoClusterSlices(GnoClusterLayout layout_) { return 1u << layout_.sliceBits; }
GNO_INLINE uint gnoClusterTileHeight(GnoClusterLayout layout_) {
    return layout_.form == GNO_CLUSTER_FLAT ? GNO_CLUSTER_FLAT_TILE_HEIGHT : GNO_CLUSTER_TILE;
}

// Words of 32 samples in the shade array: two a tile, flat: one.
GNO_INLINE uint gnoClusterShadeWords(GnoClusterLayout layout_) {
    return layout_.tiles.x * layout_.tiles.y * (gnoClusterTileHeight(layout_) / 4u);
}

GNO_NAMESPACE_END
#endif
