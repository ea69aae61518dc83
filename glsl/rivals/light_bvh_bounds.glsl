// SPDX-License-Identifier: MIT
// gnomon rivals/light_bvh_bounds.glsl : a caster's bounds on the faces of a light's cube, and where a point lies in them.
//
//   bool gnoLightBvhBounds(vec4 light, GnoForestGrid grid, uint face, GnoCellVolume v, out uint low, out uint high)       false: the volume meets no sample of the face
//   uint gnoLightBvhKey(uint face, uint low, uint high)               the order of the references: by face, then along a Morton curve
//   GnoLightBvhBox gnoLightBvhUnion(GnoLightBvhBox a, GnoLightBvhBox b)         link is a's
//   float gnoLightBvhArea(uint low, uint high)                        in cells
//   bool gnoLightBvhHolds(uint low, uint high, uint place)            the cell in column `place & 0xFFFF` and row `place >> 16` lies in the bounds
//
// Bounds are whole cells (forest/cells.glsl, 1 to 4): a point in a caster's shadow volume has its cell in the caster's bounds on its face, for certain, and comparing
// cells is exact. So a hierarchy of unions loses nothing, and only the leaves' casters are left to decide. A face is left out where gnoCellMissed is sure of its
// whole pyramid (a grid of one cell per face).
//
// Space      light coordinates; grid.resolution is GNO_LIGHT_BVH_RESOLUTION
// Stages     any; pure
// Requires   #version 450, no extension
// Source     key after Morton; boxes of cells are this project's
#ifndef GNO_RIVALS_LIGHT_BVH_BOUNDS_GLSL
#define GNO_RIVALS_LIGHT_BVH_BOUNDS_GLSL
#include "../forest/cells.glsl"
#include "light_bvh.h"
GNO_NAMESPACE_BEGIN

GNO_INLINE bool gnoLightBvhBounds(vec4 light_, GnoForestGrid grid_, uint face_, GnoCellVolume v_, GNO_OUT(uint) low_, GNO_OUT(uint) high_) {
    low_ = 0u;
    high_ = 0u;
    uvec4 cells_ = gnoCellRectangle(light_, grid_, face_, v_);
    if (cells_.x >= cells_.z) return false;
    if (light_.w != 0.0f) {
        GnoForestGrid face1_ = grid_;
        face1_.resolution = 1u;
        face1_.stepAcross = 2.0f;
        face1_.stepAlong = 2.0f;
        if (gnoCellMissed(light_, face1_, face_, uvec2(0u, 0u), v_)) return false;
    }
    low_ = cells_.x | (cells_.y << 16);
    high_ = (cells_.z - 1u) | ((cells_.w - 1u) << 16);
    return true;
}

// From the top: 3 bits of the face, then digit by digit whether the bounds are as wide as the digit's cell (the first four), and the middle's column and row.
GNO_INLINE uint gnoLightBvhKey(uint face_, uint low_, uint high_) {
    uint x_ = ((low_ & 0xFFFFu) + (high_ & 0xFFFFu)) >> 1;
    uint y_ = ((low_ >> 16) + (high_ >> 16)) >> 1;
    uint width_ = max((high_ & 0xFFFFu) - (low_ & 0xFFFFu), (high_ >> 16) - (low_ >> 16));
    uint key_ = face_;
    for (uint digit_ = 15u; digit_ > 2u; --digit_) {
        uint bit_ = digit_ - 1u;
        if (digit_ > 11u) key_ = (key_ << 1) | (width_ >> bit_ != 0u ? 1u : 0u);
        key_ = (key_ << 1) | ((x_ >> bit_) & 1u);
        if (digit_ > 3u) key_ = (key_ << 1) | ((y_ >> bit_) & 1u);
    }
    return key_;
}

GNO_INLINE uint gnoLightBvhLower_(uint a_, uint b_) { return min(a_ & 0xFFFFu, b_ & 0xFFFFu) | min(a_ & 0xFFFF0000u, b_ & 0xFFFF0000u); }
GNO_INLINE uint gnoLightBvhUpper_(uint a_, uint b_) { return max(a_ & 0xFFFFu, b_ & 0xFFFFu) | max(a_ & 0xFFFF0000u, b_ & 0xFFFF0000u); }

GNO_INLINE GnoLightBvhBox gnoLightBvhUnion(GnoLightBvhBox a_, GnoLightBvhBox b_) {
    GnoLightBvhBox both_ = a_;
    both_.low = gnoLightBvhLower_(a_.low, b_.low);
    both_.high = gnoLightBvhUpper_(a_.high, b_.high);
    both_.least = min(a_.least, b_.least);
    return both_;
}

GNO_INLINE float gnoLightBvhArea(uint low_, uint high_) {
    return float((high_ & 0xFFFFu) - (low_ & 0xFFFFu) + 1u) * float((high_ >> 16) - (low_ >> 16) + 1u);
}

// Both halves at once: with its highest bit set a half never borrows, and keeps the bit if and only if it was not the smaller one.
GNO_INLINE bool gnoLightBvhHolds(uint low_, uint high_, uint place_) {
    return ((((place_ | 0x80008000u) - low_) & ((high_ | 0x80008000u) - place_)) & 0x80008000u) == 0x80008000u;
}

GNO_NAMESPACE_END
#endif
