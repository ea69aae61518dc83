// SPDX-License-Identifier: MIT
// gnomon forest/cells.h : a grid of cells over the directions of a light, and what is kept per cell; read by glslang and by C++20 (namespace gno).
//
// Point light: a cube around it, resolution x resolution cells on each face. Directional light: one face at a right angle to it.
//
//   array     bytes                      written by                              read by
//   grid      48                         the host, when light or scene changes   all
//   cells     16 * gnoCellCount          reset, depth, cover, count, allocate    insertion and queries (root)
//   few       8 * casters                sort                                    count, emission
//   header    60                         reset, sort, allocate, emission         count, emission, set-up of the trees
//
//   uint gnoCellCount(uint resolution, uint faces)      cells of a grid
//   uint gnoForestState(GnoForestHeader header, uint capacity, uint precision)      of pairs that a pool of `capacity` was to hold (core/state.h)
//
// Space      light coordinates, q = gnoFromLight(p) (core/light.glsl)
// Stages     any
// Requires   #version 450, no extension
//
// A shader that builds says which passes it is, before bindings.glsl and assign.glsl: #define GNO_FOREST_BUILDS GNO_FOREST_PASS_COUNT; several
// with |, all: 1.
#ifndef GNO_FOREST_CELLS_H
#define GNO_FOREST_CELLS_H
#include "../core/state.h"
#define GNO_FOREST_PASS_RESET 2     // writes cells and header
#define GNO_FOREST_PASS_DEPTH 4     // cells
#define GNO_FOREST_PASS_SORT 8      // few; its caller the header and the list of casters
#define GNO_FOREST_PASS_COVER 16    // cells
#define GNO_FOREST_PASS_COUNT 32    // cells
#define GNO_FOREST_PASS_ALLOCATE 64 // cells, header
#define GNO_FOREST_PASS_EMIT 128    // cells, pairs, header
#define GNO_FOREST_PASS_SIZES 256   // header
#define GNO_FOREST_PASS_BUILD 512   // gnoTopInsert over the trees: cells
GNO_NAMESPACE_BEGIN

GNO_CONST uint GNO_FOREST_NONE = 0xFFFFFFFFu;  // no root
GNO_CONST uint GNO_FOREST_GROUP = 64u;         // invocations per work group of the passes over casters and pairs

// What gnoForestSort says of a caster (assign.glsl).
GNO_CONST uint GNO_FOREST_FEW_CELLS = 0u;      // it is in the array `few`
GNO_CONST uint GNO_FOREST_SOME_CELLS = 1u;     // at most GNO_FOREST_MOST
GNO_CONST uint GNO_FOREST_MANY_CELLS = 2u;
GNO_CONST uint GNO_FOREST_MOST = 64u;          // cells that one invocation looks at alone

struct GnoForestGrid {   // std140 and std430, 48 bytes
    vec4 across;         //  0  directional: xyz unit axis, w where the grid begins; point: w = -1, the rest unused
    vec4 along;          // 16  the same for the other axis, at a right angle to the first and to the light
    float stepAcross;    // 32  width of a cell; point: 2 / resolution
    float stepAlong;     // 36
    uint resolution;     // 40  cells along an edge of a face, a power of two in 1 .. 65536; what has an array of cells stays below 16384
    uint faces;          // 44  6 point, 1 directional
};
GNO_STRUCT_SIZE(GnoForestGrid, 48)
GNO_STRUCT_OFFSET(GnoForestGrid, stepAcross, 32)

struct GnoForestCell {   // std430, 16 bytes
    uint farthest;       //  0  1 + float bits of the greatest gnoLightDepth of a view sample in it; 0: it has none
    uint cover;          //  4  float bits: from this depth on a caster hides the whole cell; GNO_FOREST_NONE: none does
    uint pairs;          //  8  casters that are kept here; after allocation: where the next one goes
    uint root;           // 12  of its tree, GNO_FOREST_NONE: no caster can shadow a sample in here
};
GNO_STRUCT_SIZE(GnoForestCell, 16)
GNO_STRUCT_OFFSET(GnoForestCell, root, 12)

struct GnoForestFew {    // std430, 8 bytes: where a caster with at most 2 x 2 cells stands
    uint cells;          //  0  bits 0..27: its first cell; bits 28..31: in that one, the one right of it, above it, above and right of it
    uint least;          //  4  float bits of its least depth
};
GNO_STRUCT_SIZE(GnoForestFew, 8)

struct GnoForestHeader { // std430, 60 bytes
    uint groupsOfPairs;  //  0  indirect dispatch over the pairs: (groups, 1, 1)
    uint one0;
    uint one1;
    uint pairs;          // 12  pairs of cell and caster; more than the pool holds: the forest is not complete, grow the pool and build again
    uint groupsOfSome;   // 16  indirect dispatch over the casters with some cells, an invocation each
    uint one2;
    uint one3;
    uint some;           // 28  how many are listed
    uint groupsOfMany;   // 32  indirect dispatch over the casters with many cells, a work group each
    uint one4;
    uint one5;
    uint many;           // 44  how many are listed
    uint used;           // 48  cells that keep casters
    uint emitted;        // 52  pairs that were put, or found the pool full; as many as pairs, and none is missing
    uint state;          // 56  reset: gnoState(GNO_STATE_ANY)
};
GNO_STRUCT_SIZE(GnoForestHeader, 60)
GNO_STRUCT_OFFSET(GnoForestHeader, many, 44)
GNO_STRUCT_OFFSET(GnoForestHeader, state, 56)

struct GnoForestPair {   // std430, 8 bytes: block b of the pool (nodes 4b .. 4b+3) stands for this caster in this cell
    uint caster;
    uint cell;
};
GNO_STRUCT_SIZE(GnoForestPair, 8)

// The word of core/state.h of a structure over these pairs: complete, incomplete (pool too small), or 0: a pass was left out.
GNO_INLINE uint gnoForestState(GnoForestHeader header_, uint capacity_, uint precision_) {
    if (header_.state != gnoState(GNO_STATE_ANY) || header_.emitted != header_.pairs) return 0u;
    return header_.pairs > capacity_ ? gnoIncompleteState(precision_) : gnoState(precision_);
}

GNO_INLINE uint gnoCellCount(uint resolution_, uint faces_) { return faces_ * resolution_ * resolution_; }

GNO_NAMESPACE_END
#endif
