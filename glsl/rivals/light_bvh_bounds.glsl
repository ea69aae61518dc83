// SPDX-License-Identifier: MIT
// gnomon rivals/light_bvh_bounds.glsl : a caster's bounds on the faces of a light's cube, and where a point lies in them.
//
//   GnoLightBvhCaster gnoLightBvhCaster(vec4 light, GnoCaster t, int facing)         a kept caster, seen from the light; facing = gnoFacing(light,
//   t), never 0
//   uint gnoLightBvhFaces(vec4 light, GnoForestGrid grid, GnoLightBvhCaster c)        bit f: its shadow volume may meet a sample of face f
//   bool gnoLightBvhBounds(vec4 light, GnoForestGrid grid, uint face, GnoLightBvhCaster c, out uint low, out uint high)       false: it meets none
//   uint gnoLightBvhKey(uint face, uint low, uint high)               the order of the references: by face, then along a Morton curve
//   GnoLightBvhBox gnoLightBvhUnion(GnoLightBvhBox a, GnoLightBvhBox b)         link is a's
//   float gnoLightBvhArea(uint low, uint high)                        in cells
//   bool gnoLightBvhHolds(uint low, uint high, uint place)            the cell in column `place & 0xFFFF` and row `place >> 16` lies in the bounds
//
// Bounds are whole cells (forest/cells.glsl, 1 to 4): a point in a caster's shadow volume has its cell in the caster's bounds on its face, for
// certain, and comparing cells is exact. So a hierarchy of unions loses nothing, and only the leaves' casters are left to decide. A caster whose
// cells reach a face's border may pass by its corner: that face is left out where gnoCellMissed is sure of the whole pyramid (a grid of one cell per
// face).
//
// A face's side: its samples have x/z <= 1 + 2E (forest/cells.glsl, 1). If x - z (1 + 2E) > 0 at all vertices, so it is in the whole volume,
// whatever z. The computed x - z errs by 2u(|x| + |z|), so x - z > 3E(|x| + |z|) is enough.
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

struct GnoLightBvhCaster {
    GnoCaster t;
    int facing;
    GnoCellVolume v;  // its vertices alone; the rest is undefined
};

GNO_INLINE GnoLightBvhCaster gnoLightBvhCaster(vec4 light_, GnoCaster t_, int facing_) {
    GnoLightBvhCaster c_;
    c_.t = t_;
    c_.facing = facing_;
    c_.v.q0 = gnoFromLight(light_, t_.a);
    c_.v.q1 = gnoFromLight(light_, t_.b);
    c_.v.q2 = gnoFromLight(light_, t_.c);
    return c_;
}

GNO_INLINE bool gnoLightBvhBounds(vec4 light_, GnoForestGrid grid_, uint face_, GnoLightBvhCaster c_, GNO_OUT(uint) low_, GNO_OUT(uint) high_) {
    uvec4 cells_ = gnoCellRectangle(light_, grid_, face_, c_.v);
    low_ = cells_.x | (cells_.y << 16);
    high_ = (cells_.z - 1u) | ((cells_.w - 1u) << 16);
    return cells_.x < cells_.z;
}

GNO_INLINE bool gnoLightBvhBeyond_(vec3 x_, vec3 z_) {
    return x_.x - z_.x > 3.0f * GNO_BAND * (abs(x_.x) + abs(z_.x)) && x_.y - z_.y > 3.0f * GNO_BAND * (abs(x_.y) + abs(z_.y)) &&
           x_.z - z_.z > 3.0f * GNO_BAND * (abs(x_.z) + abs(z_.z));
}

// The quick answer to most faces of most casters: all vertices lie beyond the same side of the face's pyramid.
GNO_INLINE bool gnoLightBvhPasses_(vec4 light_, GnoForestGrid grid_, uint face_, GnoCellVolume v_) {
    if (light_.w == 0.0f) return false;
    vec3 a_ = gnoCellPlace(light_, grid_, face_, v_.q0);
    vec3 b_ = gnoCellPlace(light_, grid_, face_, v_.q1);
    vec3 c_ = gnoCellPlace(light_, grid_, face_, v_.q2);
    vec3 x_ = vec3(a_.x, b_.x, c_.x);
    vec3 y_ = vec3(a_.y, b_.y, c_.y);
    vec3 z_ = vec3(a_.z, b_.z, c_.z);
    return gnoLightBvhBeyond_(x_, z_) || gnoLightBvhBeyond_(-x_, z_) || gnoLightBvhBeyond_(y_, z_) || gnoLightBvhBeyond_(-y_, z_);
}

GNO_INLINE uint gnoLightBvhFaces(vec4 light_, GnoForestGrid grid_, GnoLightBvhCaster c_) {
    uint faces_ = 0u;
    uint doubtful_ = 0u;
    for (uint face_ = 0u; face_ < grid_.faces; ++face_) {
        uint low_, high_;
        if (gnoLightBvhPasses_(light_, grid_, face_, c_.v) || !gnoLightBvhBounds(light_, grid_, face_, c_, low_, high_)) continue;
        faces_ |= 1u << face_;
        uint last_ = grid_.resolution - 1u;
        bool inner_ = (low_ & 0xFFFFu) != 0u && (low_ >> 16) != 0u && (high_ & 0xFFFFu) != last_ && (high_ >> 16) != last_;
        if (!inner_ && light_.w != 0.0f) doubtful_ |= 1u << face_;
    }
    if (doubtful_ == 0u) return faces_;
    GnoForestGrid whole_ = grid_;  // a cell a face
    whole_.resolution = 1u;
    whole_.stepAcross = 2.0f;
    whole_.stepAlong = 2.0f;
    GnoCellVolume v_ = gnoCellVolume(light_, c_.t, c_.facing);
    for (uint face_ = 0u; face_ < grid_.faces; ++face_) {
        if ((doubtful_ & (1u << face_)) != 0u && gnoCellMissed(light_, whole_, face_, uvec2(0u, 0u), v_)) faces_ &= ~(1u << face_);
    }
    return faces_;
}

// From the top: 3 bits of the face, then digit by digit whether the bounds are as wide as the digit's cell (the first four), and the middle's column
// and row.
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
