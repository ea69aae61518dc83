// SPDX-License-Identifier: MIT
// gnomon forest/assign.glsl : which casters stand in which cells. A caster is kept in a cell that its shadow volume may meet, unless it starts
// beyond the cell's farthest view sample, or beyond a caster that hides the whole cell.
//
//   void gnoForestReset(uint cell)                                            0: one invocation per cell: an empty one; cell 0: the header, too
//   GnoForestSeen gnoForestSeen()                                             1: what an invocation begins with,
//   void gnoForestSeeSample(inout GnoForestSeen seen, vec3 p)                 1: calls for each of its view samples
//   void gnoForestTell(GnoForestSeen seen)                                    1: and ends with: cells know how far their samples lie
//   uint gnoForestSort(uint caster, GnoCellVolume v)                          2: GNO_FOREST_FEW_CELLS, _SOME_CELLS or _MANY_CELLS; gnoCellSight is
//   enough for v
//   void gnoForestNone(uint caster)                                           2, for a caster that is left out
//   void gnoForestCover(GnoCellVolume v, uint lane, uint lanes)               3: cells learn which depth hides them; some and many
//   void gnoForestCountFew(uint caster)                                       4: how many casters each cell keeps
//   void gnoForestCount(GnoCellVolume v, uint lane, uint lanes)               4, some and many
//   void gnoForestAllocate(uint cell)                                         5: where its casters go in the pool
//   void gnoForestEmitFew(uint caster)                                        6: puts them there
//   void gnoForestEmit(uint caster, GnoCellVolume v, uint lane, uint lanes)   6, some and many
//   void gnoForestSizes()                                                     after 2 and 5, one invocation: group counts for the passes over lists
//   and pairs
//
// Each step is a dispatch of its own, over samples (1), casters (2, 4, 6) or cells (0, 5). Most casters have one to four cells: what 2 finds out
// about them is kept, 4 and 6 only look it up. The others 2 asks the caller to list: `some` are worked on by an invocation each, (lane, lanes) = (0,
// 1), `many` by a work group each whose lanes take every `lanes`-th cell. 4 and 6 see the same cells, so what is counted is what is put: a pool of
// header.pairs pairs is filled exactly. In a smaller one the rest is left out and header.pairs tells: the forest is not complete then
// (gnoForestState of cells.h), and a query over it answers GNO_VISIBILITY_UNKNOWN. Call 6 for `many` and `some` first: large casters are better
// pivots.
//
// Space      light coordinates; samples on the scene grid
// Stages     any with storage buffers; may diverge
// Requires   #version 450, no extension
// Reads      grid, cells
// Writes     cells, pairs, header, by atomics (1, 3, 4, 6) or alone (0, 5); few (2)
// Cost       some and many: 3 plane evaluations per cell and caster
//
// Macro                     required  default  meaning
// GNO_FOREST_BUILDS         no        1        which steps this shader has: 1 GNO_FOREST_PASS_DEPTH, 2 .._SORT, 3 .._COVER, 4 .._COUNT,
//                                              5 .._ALLOCATE, 6 .._EMIT, .._SIZES; several with |, 1 for all; bindings.glsl makes writable what
//                                              they write
// GNO_FOREST_GRID           yes       -        GnoForestGrid
// GNO_FOREST_CELLS          yes       -        array of GnoForestCell in a storage buffer, gnoCellCount
// GNO_FOREST_FEW            yes       -        array of GnoForestFew in a storage buffer, one per caster
// GNO_FOREST_PAIRS          yes       -        array of GnoForestPair in a storage buffer
// GNO_FOREST_CAPACITY       yes       -        pairs that the pool holds
// GNO_FOREST_HEADER         yes       -        GnoForestHeader in a storage buffer
// GNO_LIGHT                 yes       -        vec4, homogeneous (core/light.glsl)
// GNO_FOREST_VIEW_CULL      no        1        1: casters beyond the cell's samples are left out, the forest is good for this view; 0: for any
// GNO_FOREST_USE_COVER      no        1        1: casters beyond a covering one are left out
#ifndef GNO_FOREST_ASSIGN_GLSL
#define GNO_FOREST_ASSIGN_GLSL
#include "../core/counters.glsl"
#include "cells.glsl"
#ifndef GNO_FOREST_BUILDS
#define GNO_FOREST_BUILDS 1
#endif
#if (GNO_FOREST_BUILDS) == 0
#error "forest/assign.glsl: which pass is this? define GNO_FOREST_BUILDS before forest/bindings.glsl, as forest/cells.h says"
#endif
#if !defined(GNO_FOREST_GRID) || !defined(GNO_FOREST_CELLS) || !defined(GNO_FOREST_FEW) || !defined(GNO_FOREST_PAIRS)
#error "forest/assign.glsl: define GNO_FOREST_GRID, GNO_FOREST_CELLS, GNO_FOREST_FEW and GNO_FOREST_PAIRS (or include bindings.glsl)"
#endif
#if !defined(GNO_FOREST_CAPACITY) || !defined(GNO_FOREST_HEADER)
#error "forest/assign.glsl: define GNO_FOREST_CAPACITY and GNO_FOREST_HEADER (or include bindings.glsl)"
#endif
#ifndef GNO_LIGHT
#error "forest/assign.glsl: define GNO_LIGHT, a homogeneous vec4"
#endif
#ifndef GNO_FOREST_VIEW_CULL
#define GNO_FOREST_VIEW_CULL 1
#endif
#ifndef GNO_FOREST_USE_COVER
#define GNO_FOREST_USE_COVER 1
#endif
GNO_NAMESPACE_BEGIN

#if (GNO_FOREST_BUILDS) & (1 | GNO_FOREST_PASS_RESET)
GNO_INLINE void gnoForestReset(uint cell_) {
    if (cell_ == 0u)
        GNO_FOREST_HEADER = GnoForestHeader(0u, 1u, 1u, 0u, 0u, 1u, 1u, 0u, 0u, 1u, 1u, 0u, 0u, 0u, gnoState(GNO_STATE_ANY));
    GNO_FOREST_CELLS[cell_] = GnoForestCell(0u, GNO_FOREST_NONE, 0u, GNO_FOREST_NONE);
}
#endif

#if (GNO_FOREST_BUILDS) & (1 | GNO_FOREST_PASS_DEPTH)
struct GnoForestSeen {  // the farthest of an invocation's samples in one cell
    uint cell;
    uint depth;
};

GNO_INLINE GnoForestSeen gnoForestSeen() { return GnoForestSeen(0u, 0u); }

GNO_INLINE void gnoForestTell(GnoForestSeen seen_) {
    if (seen_.depth > 0u) atomicMax(GNO_FOREST_CELLS[seen_.cell].farthest, seen_.depth);
}

GNO_INLINE void gnoForestSeeSample(GNO_INOUT(GnoForestSeen) seen_, vec3 p_) {
    vec3 q_ = gnoFromLight(GNO_LIGHT, p_);
    uint depth_ = floatBitsToUint(gnoLightDepth(GNO_LIGHT, q_)) + 1u;
    uint cell_ = gnoCellOf(GNO_LIGHT, GNO_FOREST_GRID, q_);
    if (cell_ != seen_.cell) {
        gnoForestTell(seen_);
        seen_ = GnoForestSeen(cell_, 0u);
    }
    seen_.depth = max(seen_.depth, depth_);
}
#endif

GNO_INLINE uint gnoForestCell_(uint face_, uvec2 at_) { return (face_ * GNO_FOREST_GRID.resolution + at_.y) * GNO_FOREST_GRID.resolution + at_.x; }

// By view samples and covering casters alone.
GNO_INLINE bool gnoForestHasSamples_(uint cell_, uint least_) {
    return GNO_FOREST_VIEW_CULL == 0 || GNO_FOREST_CELLS[cell_].farthest > least_;  // farthest is 1 + the bits of the depth, or 0
}

GNO_INLINE bool gnoForestOpen_(uint cell_, uint least_) { return GNO_FOREST_USE_COVER == 0 || GNO_FOREST_CELLS[cell_].cover >= least_; }

#if (GNO_FOREST_BUILDS) & (1 | GNO_FOREST_PASS_SORT)
GNO_INLINE void gnoForestNone(uint caster_) { GNO_FOREST_FEW[caster_] = GnoForestFew(0u, 0u); }

GNO_INLINE uint gnoForestSort(uint caster_, GnoCellVolume v_) {
    uint span_ = 0u;
    uint cell_ = 0u;
    uvec2 size_ = uvec2(0u, 0u);
    for (uint face_ = v_.face; face_ < v_.faceEnd; ++face_) {
        uvec4 r_ = gnoCellRectangle(GNO_LIGHT, GNO_FOREST_GRID, face_, v_);
        uvec2 wide_ = uvec2(r_.z - r_.x, r_.w - r_.y);
        if (wide_.x * wide_.y == 0u) continue;
        cell_ = gnoForestCell_(face_, uvec2(r_.x, r_.y));
        size_ = span_ == 0u ? wide_ : uvec2(3u, 3u);  // on two faces: not a few
        span_ += wide_.x * wide_.y;
    }
    gnoForestNone(caster_);
    if (span_ > GNO_FOREST_MOST) return GNO_FOREST_MANY_CELLS;
    if (max(size_.x, size_.y) > 2u) return GNO_FOREST_SOME_CELLS;
    uint least_ = floatBitsToUint(v_.least);
    uint kept_ = 0u;
    for (uint n_ = 0u; n_ < 4u; ++n_) {  // none of them is missed for certain: only corners of 2 x 2 could be
        if ((n_ & 1u) < size_.x && (n_ >> 1) < size_.y && gnoForestHasSamples_(cell_ + (n_ & 1u) + (n_ >> 1) * GNO_FOREST_GRID.resolution, least_))
            kept_ |= 1u << n_;
    }
    if (kept_ != 0u) GNO_FOREST_FEW[caster_] = GnoForestFew(cell_ | (kept_ << 28), least_);
    return GNO_FOREST_FEW_CELLS;
}
#endif

#if (GNO_FOREST_BUILDS) & (1 | GNO_FOREST_PASS_COVER)
GNO_INLINE void gnoForestCover(GnoCellVolume v_, uint lane_, uint lanes_) {
    if (!v_.bounded) return;
    for (uint face_ = v_.face; face_ < v_.faceEnd; ++face_) {
        uvec4 r_ = gnoCellRectangle(GNO_LIGHT, GNO_FOREST_GRID, face_, v_);
        uvec2 wide_ = uvec2(r_.z - r_.x, r_.w - r_.y);
        // a covered cell has met neighbours on all sides; one at the face's border is not worth more tests
        if (min(wide_.x, wide_.y) < 3u) continue;
        for (uint n_ = lane_; n_ < wide_.x * wide_.y; n_ += lanes_) {
            uvec2 at_ = uvec2(r_.x + n_ % wide_.x, r_.y + n_ / wide_.x);
            if (gnoCellCovered(GNO_LIGHT, GNO_FOREST_GRID, face_, at_, v_))
                atomicMin(GNO_FOREST_CELLS[gnoForestCell_(face_, at_)].cover, floatBitsToUint(v_.most));
        }
    }
}
#endif

#if (GNO_FOREST_BUILDS) & (1 | GNO_FOREST_PASS_COUNT | GNO_FOREST_PASS_EMIT)
GNO_INLINE bool gnoForestKeeps_(uint face_, uvec2 at_, GnoCellVolume v_, bool all_) {
    uint cell_ = gnoForestCell_(face_, at_);
    uint least_ = floatBitsToUint(v_.least);
    if (!gnoForestHasSamples_(cell_, least_) || !gnoForestOpen_(cell_, least_)) return false;
    return all_ || !gnoCellMissed(GNO_LIGHT, GNO_FOREST_GRID, face_, at_, v_);
}

// A caster and a cell that keeps it: counted, or put into the pool.
GNO_INLINE void gnoForestPair_(uint caster_, uint cell_, bool put_, GNO_INOUT(uint) kept_) {
    uint before_ = atomicAdd(GNO_FOREST_CELLS[cell_].pairs, 1u);
    ++kept_;
#if (GNO_FOREST_BUILDS) & (1 | GNO_FOREST_PASS_EMIT)
    if (put_ && before_ < GNO_FOREST_CAPACITY) GNO_FOREST_PAIRS[before_] = GnoForestPair(caster_, cell_);
#endif
}

GNO_INLINE void gnoForestFew_(uint caster_, bool put_) {
    GnoForestFew few_ = GNO_FOREST_FEW[caster_];
    uint kept_ = 0u;
    for (uint n_ = 0u; n_ < 4u; ++n_) {
        uint cell_ = (few_.cells & 0x0FFFFFFFu) + (n_ & 1u) + (n_ >> 1) * GNO_FOREST_GRID.resolution;
        if ((few_.cells & (1u << (28u + n_))) == 0u || !gnoForestOpen_(cell_, few_.least)) continue;
        gnoForestPair_(caster_, cell_, put_, kept_);
    }
    if (put_ && kept_ > 0u) atomicAdd(GNO_FOREST_HEADER.emitted, kept_);
}

GNO_INLINE void gnoForestMore_(uint caster_, GnoCellVolume v_, uint lane_, uint lanes_, bool put_) {
    uint kept_ = 0u;
    for (uint face_ = v_.face; face_ < v_.faceEnd; ++face_) {
        uvec4 r_ = gnoCellRectangle(GNO_LIGHT, GNO_FOREST_GRID, face_, v_);
        uint width_ = r_.z - r_.x;
        uint height_ = r_.w - r_.y;
        for (uint n_ = lane_; n_ < width_ * height_; n_ += lanes_) {
            uvec2 at_ = uvec2(r_.x + n_ % width_, r_.y + n_ / width_);
            if (gnoForestKeeps_(face_, at_, v_, min(width_, height_) == 1u)) gnoForestPair_(caster_, gnoForestCell_(face_, at_), put_, kept_);
        }
    }
    if (put_ && kept_ > 0u) atomicAdd(GNO_FOREST_HEADER.emitted, kept_);
}
#endif

#if (GNO_FOREST_BUILDS) & (1 | GNO_FOREST_PASS_COUNT)
GNO_INLINE void gnoForestCountFew(uint caster_) { gnoForestFew_(caster_, false); }

GNO_INLINE void gnoForestCount(GnoCellVolume v_, uint lane_, uint lanes_) { gnoForestMore_(0u, v_, lane_, lanes_, false); }
#endif

#if (GNO_FOREST_BUILDS) & (1 | GNO_FOREST_PASS_EMIT)
GNO_INLINE void gnoForestEmitFew(uint caster_) { gnoForestFew_(caster_, true); }

GNO_INLINE void gnoForestEmit(uint caster_, GnoCellVolume v_, uint lane_, uint lanes_) { gnoForestMore_(caster_, v_, lane_, lanes_, true); }
#endif

#if (GNO_FOREST_BUILDS) & (1 | GNO_FOREST_PASS_ALLOCATE)
GNO_INLINE void gnoForestAllocate(uint cell_) {
    uint count_ = GNO_FOREST_CELLS[cell_].pairs;
    GNO_FOREST_CELLS[cell_].root = GNO_FOREST_NONE;
    if (count_ == 0u) return;
    GNO_FOREST_CELLS[cell_].pairs = atomicAdd(GNO_FOREST_HEADER.pairs, count_);
    atomicAdd(GNO_FOREST_HEADER.used, 1u);
}
#endif

#if (GNO_FOREST_BUILDS) & (1 | GNO_FOREST_PASS_SIZES)
GNO_INLINE void gnoForestSizes() {
    bool reset_ = GNO_FOREST_HEADER.state == gnoState(GNO_STATE_ANY);  // else all of it may be any number
    uint pairs_ = reset_ ? min(GNO_FOREST_HEADER.pairs, GNO_FOREST_CAPACITY) : 0u;
    uint some_ = reset_ ? GNO_FOREST_HEADER.some : 0u;
    uint many_ = reset_ ? GNO_FOREST_HEADER.many : 0u;
    // without any: one group writes the header of the trees
    GNO_FOREST_HEADER.groupsOfPairs = max(1u, (pairs_ + GNO_FOREST_GROUP - 1u) / GNO_FOREST_GROUP);
    GNO_FOREST_HEADER.groupsOfSome = (some_ + GNO_FOREST_GROUP - 1u) / GNO_FOREST_GROUP;
    GNO_FOREST_HEADER.groupsOfMany = min(many_, 65535u);
}
#endif

GNO_NAMESPACE_END
#endif
