// SPDX-License-Identifier: MIT
// gnomon forest/assign.glsl : which casters stand in which cells. A caster is kept in a cell that its shadow volume may meet, unless it starts beyond the cell's
// farthest view sample, or beyond a caster that hides the whole cell.
//
//   void gnoForestSeeSample(vec3 p)                                           1: one view sample; cells know how far their samples lie
//   uint gnoForestSpan(GnoCellVolume v)                                       cells to look at for a caster: few, or too many for one invocation
//   void gnoForestCover(GnoCellVolume v, uint lane, uint lanes)               2: cells learn which depth hides them
//   void gnoForestCount(GnoCellVolume v, uint lane, uint lanes)               3: how many casters each cell keeps
//   void gnoForestAllocate(uint cell)                                         4: where its casters go in the pool
//   void gnoForestEmit(uint caster, GnoCellVolume v, uint lane, uint lanes)   5: puts them there
//   void gnoForestSizes()                                                     after 4, one invocation: group counts for the passes over pairs and over large casters
//
// Each step is a dispatch of its own, over samples (1), casters (2, 3, 5) or cells (4). Of a caster's cells the lanes take every `lanes`-th: an invocation alone calls with
// (0, 1), a work group shares a caster among its lanes. 3 and 5 see the same cells, so what is counted is what is put: a pool of header.pairs pairs is filled exactly. In a
// smaller one the rest is left out and header.pairs tells: the forest is not complete then, and no query over it means anything.
//
// Space      light coordinates; samples on the scene grid
// Stages     any with storage buffers; may diverge
// Requires   #version 450, no extension
// Reads      grid, cells
// Writes     cells, pairs, header, by atomics (1, 2, 3, 5) or alone (4)
// Cost       per cell and caster 12 plane evaluations; most casters have one to four cells
//
// Macro                     required  default  meaning
// GNO_FOREST_GRID           yes       -        GnoForestGrid
// GNO_FOREST_CELLS          yes       -        array of GnoForestCell in a storage buffer, gnoCellCount
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
#if !defined(GNO_FOREST_GRID) || !defined(GNO_FOREST_CELLS) || !defined(GNO_FOREST_PAIRS) || !defined(GNO_FOREST_CAPACITY) || !defined(GNO_FOREST_HEADER)
#error "forest/assign.glsl: define GNO_FOREST_GRID, GNO_FOREST_CELLS, GNO_FOREST_PAIRS, GNO_FOREST_CAPACITY and GNO_FOREST_HEADER or include forest/bindings.glsl before this file"
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

GNO_INLINE void gnoForestSeeSample(vec3 p_) {
    vec3 q_ = gnoFromLight(GNO_LIGHT, p_);
    uint depth_ = floatBitsToUint(gnoLightDepth(GNO_LIGHT, q_)) + 1u;
    uint cell_ = gnoCellOf(GNO_LIGHT, GNO_FOREST_GRID, q_);
    atomicMax(GNO_FOREST_CELLS[cell_].farthest, depth_);
}

GNO_INLINE uint gnoForestSpan(GnoCellVolume v_) {
    uint span_ = 0u;
    for (uint face_ = 0u; face_ < GNO_FOREST_GRID.faces; ++face_) {
        uvec4 r_ = gnoCellRectangle(GNO_LIGHT, GNO_FOREST_GRID, face_, v_);
        span_ += (r_.z - r_.x) * (r_.w - r_.y);
    }
    return span_;
}

GNO_INLINE uint gnoForestCell_(uint face_, uvec2 at_) { return (face_ * GNO_FOREST_GRID.resolution + at_.y) * GNO_FOREST_GRID.resolution + at_.x; }

GNO_INLINE void gnoForestCover(GnoCellVolume v_, uint lane_, uint lanes_) {
    if (!v_.bounded) return;
    for (uint face_ = 0u; face_ < GNO_FOREST_GRID.faces; ++face_) {
        uvec4 r_ = gnoCellRectangle(GNO_LIGHT, GNO_FOREST_GRID, face_, v_);
        uint width_ = r_.z - r_.x;
        for (uint n_ = lane_; n_ < width_ * (r_.w - r_.y); n_ += lanes_) {
            uvec2 at_ = uvec2(r_.x + n_ % width_, r_.y + n_ / width_);
            if (gnoCellCovered(GNO_LIGHT, GNO_FOREST_GRID, face_, at_, v_)) atomicMin(GNO_FOREST_CELLS[gnoForestCell_(face_, at_)].cover, floatBitsToUint(v_.most));
        }
    }
}

GNO_INLINE bool gnoForestKeeps_(uint face_, uvec2 at_, GnoCellVolume v_, bool alone_) {
    uint cell_ = gnoForestCell_(face_, at_);
    uint least_ = floatBitsToUint(v_.least);
    if (GNO_FOREST_VIEW_CULL != 0 && GNO_FOREST_CELLS[cell_].farthest <= least_) return false;  // farthest is 1 + the bits of the depth, or 0
    if (GNO_FOREST_USE_COVER != 0 && GNO_FOREST_CELLS[cell_].cover < least_) return false;
    return alone_ || !gnoCellMissed(GNO_LIGHT, GNO_FOREST_GRID, face_, at_, v_);
}

GNO_INLINE void gnoForestCount(GnoCellVolume v_, uint lane_, uint lanes_) {
    for (uint face_ = 0u; face_ < GNO_FOREST_GRID.faces; ++face_) {
        uvec4 r_ = gnoCellRectangle(GNO_LIGHT, GNO_FOREST_GRID, face_, v_);
        uint width_ = r_.z - r_.x;
        uint count_ = width_ * (r_.w - r_.y);
        for (uint n_ = lane_; n_ < count_; n_ += lanes_) {
            uvec2 at_ = uvec2(r_.x + n_ % width_, r_.y + n_ / width_);
            if (gnoForestKeeps_(face_, at_, v_, count_ == 1u)) atomicAdd(GNO_FOREST_CELLS[gnoForestCell_(face_, at_)].pairs, 1u);
        }
    }
}

GNO_INLINE void gnoForestAllocate(uint cell_) {
    uint count_ = GNO_FOREST_CELLS[cell_].pairs;
    GNO_FOREST_CELLS[cell_].root = GNO_FOREST_NONE;
    if (count_ > 0u) GNO_FOREST_CELLS[cell_].pairs = atomicAdd(GNO_FOREST_HEADER.pairs, count_);
}

GNO_INLINE void gnoForestEmit(uint caster_, GnoCellVolume v_, uint lane_, uint lanes_) {
    for (uint face_ = 0u; face_ < GNO_FOREST_GRID.faces; ++face_) {
        uvec4 r_ = gnoCellRectangle(GNO_LIGHT, GNO_FOREST_GRID, face_, v_);
        uint width_ = r_.z - r_.x;
        uint count_ = width_ * (r_.w - r_.y);
        for (uint n_ = lane_; n_ < count_; n_ += lanes_) {
            uvec2 at_ = uvec2(r_.x + n_ % width_, r_.y + n_ / width_);
            if (!gnoForestKeeps_(face_, at_, v_, count_ == 1u)) continue;
            uint cell_ = gnoForestCell_(face_, at_);
            uint slot_ = atomicAdd(GNO_FOREST_CELLS[cell_].pairs, 1u);
            if (slot_ < GNO_FOREST_CAPACITY) GNO_FOREST_PAIRS[slot_] = GnoForestPair(caster_, cell_);
        }
    }
}

GNO_INLINE void gnoForestSizes() {
    uint pairs_ = min(GNO_FOREST_HEADER.pairs, GNO_FOREST_CAPACITY);
    GNO_FOREST_HEADER.groupsOfPairs = (pairs_ + GNO_FOREST_GROUP - 1u) / GNO_FOREST_GROUP;
    GNO_FOREST_HEADER.groupsOfLarge = min(GNO_FOREST_HEADER.large, 65535u);
}

GNO_NAMESPACE_END
#endif
