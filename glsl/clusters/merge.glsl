// SPDX-License-Identifier: MIT
// gnomon clusters/merge.glsl : the answer for one view sample, after all shadow volumes went through the hierarchy.
// After Sintorn et al., I3D 2014, section 2 (the final pass over trivially accepted nodes).
//
//   uint gnoClusterAnswer(uvec2 pixel, vec3 p)        GNO_VISIBILITY_SHADOW: a volume holds the sample itself, or one of the nodes it lies in; _LIT:
//                                                     none does; _UNKNOWN: there is no hierarchy that all volumes went through
//   bool gnoClusterInShadow(uvec2 pixel, vec3 p)      the same for two answers: true where it is not lit
//
// Space      p on the scene grid: the view sample of that pixel, the same as in the build
// Stages     any with storage buffers; may diverge
// Requires   #version 450, no extension
// Reads      slices, masks, shade
// Cost       a look-up of the slice (8 to 12 reads) and one read per level
//
// Macro                        required  default                   meaning
// GNO_CLUSTER_STATE            yes       -                         uint: gnoState(GNO_STATE_ANY) where there is one (core/state.h)
// GNO_CLUSTER_SHADE            yes       -                         array of uint, gnoClusterShadeWords
// The macros of nodes.glsl
#ifndef GNO_CLUSTERS_MERGE_GLSL
#define GNO_CLUSTERS_MERGE_GLSL
#include "nodes.glsl"
#if !defined(GNO_CLUSTER_STATE) || !defined(GNO_CLUSTER_SHADE)
#error "clusters/merge.glsl: define GNO_CLUSTER_STATE and GNO_CLUSTER_SHADE or include clusters/bindings.glsl before this file"
#endif

uint gnoClusterAnswer(uvec2 pixel_, vec3 p_) {
    if (GNO_CLUSTER_STATE != gnoState(GNO_STATE_ANY)) return GNO_VISIBILITY_UNKNOWN;
    uint height_ = gnoClusterTileHeight(GNO_CLUSTER_LAYOUT);
    uvec2 tile_ = uvec2(pixel_.x / GNO_CLUSTER_TILE, pixel_.y / height_);
    uint bit_ = (pixel_.y % height_) * GNO_CLUSTER_TILE + pixel_.x % GNO_CLUSTER_TILE;
    uint word_ = (tile_.y * GNO_CLUSTER_LAYOUT.tiles.x + tile_.x) * (height_ / 4u) + (bit_ >> 5u);
    if ((GNO_CLUSTER_SHADE[word_] & (1u << (bit_ & 31u))) != 0u) return GNO_VISIBILITY_SHADOW;
    uint key_ = gnoClusterLeafKey(tile_, gnoClusterDepth(GNO_CLUSTER_FRAME, p_));
    for (uint depth_ = GNO_CLUSTER_LAYOUT.levels; depth_ > 0u; --depth_) {
        uint mask_ = GNO_CLUSTER_MASKS[gnoClusterWord(GNO_CLUSTER_LAYOUT, depth_ - 1u, key_ >> 5u)];
        if ((mask_ & (1u << (key_ & 31u))) == 0u) return GNO_VISIBILITY_SHADOW;
        key_ >>= 5u;
    }
    return GNO_VISIBILITY_LIT;
}

bool gnoClusterInShadow(uvec2 pixel_, vec3 p_) { return gnoClusterAnswer(pixel_, p_) != GNO_VISIBILITY_LIT; }
#endif
