// SPDX-License-Identifier: MIT
// gnomon clusters/nodes.glsl : finding a sample's cluster and a node's bounds in the arrays of a hierarchy.
// After Sintorn et al., I3D 2014, section 2 and 3 (the compact form).
//
//   uint  gnoClusterSliceOf(float depth)                  the slice that holds a depth between the measured ones
//   uint  gnoClusterLeafKey(uvec2 tile, float depth)      key of the cluster
//   uint  gnoClusterBoxIndex(uint depth, uint key)        where the bounds of a node at depth 1 .. levels lie; GNO_CLUSTER_NONE where it has none
//   uvec2 gnoClusterTilePixel(uint form, uvec2 tile, uint index)      pixel `index` of a tile, row by row
//
// Space      depths as gnoClusterDepth (key.glsl)
// Stages     any with storage buffers; may diverge
// Requires   #version 450, no extension
// Reads      slices, low, high, pointers
//
// Macro                        required  default                   meaning
// GNO_CLUSTER_FRAME            yes       -                         GnoClusterFrame
// GNO_CLUSTER_LAYOUT           yes       -                         GnoClusterLayout, gnoClusterLayout(frame.size, form)
// GNO_CLUSTER_FORM             yes       -                         GNO_CLUSTER_IMPLICIT, ..._EXPLICIT, ..._COMPACT or ..._FLAT
// GNO_CLUSTER_SLICES           yes       -                         array of float
// GNO_CLUSTER_MASKS            yes       -                         array of uint, gnoClusterWordCount
// GNO_CLUSTER_LOW              yes       -                         array of float, 3 per box (flat: 1 per node)
// GNO_CLUSTER_HIGH             yes       -                         array of float, 3 per box (flat: 1 per node)
// GNO_CLUSTER_POINTERS         yes       -                         array of uvec2: first box of a word's children, and its mask (compact)
#ifndef GNO_CLUSTERS_NODES_GLSL
#define GNO_CLUSTERS_NODES_GLSL
#include "key.glsl"
#if !defined(GNO_CLUSTER_FRAME) || !defined(GNO_CLUSTER_LAYOUT) || !defined(GNO_CLUSTER_FORM) || !defined(GNO_CLUSTER_SLICES)
#error "clusters/nodes.glsl: define GNO_CLUSTER_FRAME, GNO_CLUSTER_LAYOUT, GNO_CLUSTER_FORM and GNO_CLUSTER_SLICES (or include bindings.glsl)"
#endif
#if !defined(GNO_CLUSTER_MASKS) || !defined(GNO_CLUSTER_LOW) || !defined(GNO_CLUSTER_HIGH) || !defined(GNO_CLUSTER_POINTERS)
#error "clusters/nodes.glsl: define GNO_CLUSTER_MASKS, GNO_CLUSTER_LOW, GNO_CLUSTER_HIGH and GNO_CLUSTER_POINTERS (or include bindings.glsl)"
#endif

// Beginnings below and above: at every step entry low <= depth < entry high, or high is the end.
uint gnoClusterSliceOf(float depth_) {
    uint low_ = 0u;
    uint high_ = gnoClusterSlices(GNO_CLUSTER_LAYOUT);
    while (high_ - low_ > 1u) {
        uint middle_ = (low_ + high_) >> 1u;
        if (GNO_CLUSTER_SLICES[middle_] <= depth_) low_ = middle_;
        else high_ = middle_;
    }
    return low_;
}

uint gnoClusterLeafKey(uvec2 tile_, float depth_) {
    uint key_ = gnoClusterDeposit(tile_.x, GNO_CLUSTER_LAYOUT.maskX) | gnoClusterDeposit(tile_.y, GNO_CLUSTER_LAYOUT.maskY);
    if (GNO_CLUSTER_FORM != GNO_CLUSTER_FLAT) key_ |= gnoClusterDeposit(gnoClusterSliceOf(depth_), GNO_CLUSTER_LAYOUT.maskZ);
    return key_;
}

uvec2 gnoClusterTilePixel(uint form_, uvec2 tile_, uint invocation_) {
    uint height_ = form_ == GNO_CLUSTER_FLAT ? GNO_CLUSTER_FLAT_TILE_HEIGHT : GNO_CLUSTER_TILE;
    return uvec2(tile_.x * GNO_CLUSTER_TILE + (invocation_ & 7u), tile_.y * height_ + (invocation_ >> 3u));
}

uint gnoClusterBoxIndex(uint depth_, uint key_) {
    if (GNO_CLUSTER_FORM != GNO_CLUSTER_COMPACT) return gnoClusterFirstNode(GNO_CLUSTER_LAYOUT, depth_) + key_;
    uvec2 pointer_ = GNO_CLUSTER_POINTERS[gnoClusterWord(GNO_CLUSTER_LAYOUT, depth_ - 1u, key_ >> 5u)];
    if (pointer_.x == GNO_CLUSTER_NONE) return GNO_CLUSTER_NONE;
    return pointer_.x + bitCount(pointer_.y & ((1u << (key_ & 31u)) - 1u));
}

vec3 gnoClusterLow_(uint index_) {
    uint at_ = 3u * index_;
    return vec3(GNO_CLUSTER_LOW[at_], GNO_CLUSTER_LOW[at_ + 1u], GNO_CLUSTER_LOW[at_ + 2u]);
}

vec3 gnoClusterHigh_(uint index_) {
    uint at_ = 3u * index_;
    return vec3(GNO_CLUSTER_HIGH[at_], GNO_CLUSTER_HIGH[at_ + 1u], GNO_CLUSTER_HIGH[at_ + 2u]);
}
#endif
