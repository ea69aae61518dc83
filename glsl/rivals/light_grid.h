// SPDX-License-Identifier: MIT
// gnomon rivals/light_grid.h : lists of casters per cell of the light's grid, in order of least depth; read by glslang and by C++20 (namespace gno).
//
//   uint gnoLightGridFirstSub(uint cells)                the first list of a sub cell: the cells' own lists come before it, in whole work groups
//   uint gnoLightGridLists(uint cells, uint nests)       how many lists there are, with sub cells for `nests` cells
//   uint gnoLightGridState(GnoLightGridHeader header, bool planes)       the word of core/state.h: may these lists be asked?
//
// The cells are those of forest/cells.h. A cell with many casters is divided into 8 x 8 sub cells, which are cells of a grid of eight times the
// resolution: what forest/cells.glsl derives holds for them as it does for the cells.
//
//   array     bytes                                 written by                          read by
//   lists     8 * gnoLightGridLists(cells, nests)   open, count, allocate, emit         queries
//   depths    4 * 64 nests                          open, see sample                    count, emit
//   items     8 * header.items                      emit, sort                          sort, queries
//   header    52                                    reset, open, allocate, sizes, emit, finish     dispatches, queries (state)
//   planes    64 n, where queries use them          light_grid_planes.glsl              queries
//
// `depths` holds a uint per sub cell: 1 + float bits of the greatest gnoLightDepth of a view sample in it, or 0.
//
// Space      light coordinates, q = gnoFromLight(p) (core/light.glsl)
// Stages     any
// Requires   #version 450, no extension
//
// A shader that builds says which passes it is, before light_grid_bindings.glsl: #define GNO_LIGHT_GRID_BUILDS GNO_LIGHT_GRID_PASS_COUNT; several
// with |, all: 1. Opening calls gnoForestAllocate: that shader has GNO_FOREST_BUILDS GNO_FOREST_PASS_ALLOCATE, too.
#ifndef GNO_RIVALS_LIGHT_GRID_H
#define GNO_RIVALS_LIGHT_GRID_H
#include "../core/state.h"
#define GNO_LIGHT_GRID_PASS_RESET 2      // writes header
#define GNO_LIGHT_GRID_PASS_OPEN 4       // lists, depths, header
#define GNO_LIGHT_GRID_PASS_SIZES 8      // header
#define GNO_LIGHT_GRID_PASS_DEPTH 16     // depths
#define GNO_LIGHT_GRID_PASS_COUNT 32     // lists
#define GNO_LIGHT_GRID_PASS_ALLOCATE 64  // lists, header
#define GNO_LIGHT_GRID_PASS_EMIT 128     // lists, items, header
#define GNO_LIGHT_GRID_PASS_SORT 256     // items, header
#define GNO_LIGHT_GRID_PASS_PLANES 512   // planes, by its caller; header
GNO_NAMESPACE_BEGIN

GNO_CONST uint GNO_LIGHT_GRID_NESTED = 0xFFFFFFFFu;  // in `end`: the cell has sub cells
GNO_CONST uint GNO_LIGHT_GRID_FRONT = 0x80000000u;   // in `caster`: its facing is positive
GNO_CONST uint GNO_LIGHT_GRID_GROUP = 64u;           // invocations per work group, lists per work group of the sort, sub cells of a cell

struct GnoLightGridList {    // std430, 8 bytes
    uint first;              //  0  of its items; where the cell is nested: of its 64 lists
    uint end;                //  4  one past its last item
};
GNO_STRUCT_SIZE(GnoLightGridList, 8)
GNO_STRUCT_OFFSET(GnoLightGridList, end, 4)

struct GnoLightGridItem {    // std430, 8 bytes
    uint depth;              //  0  float bits of gnoTopLeastDepth
    uint caster;             //  4  below 2^31; GNO_LIGHT_GRID_FRONT is its facing
};
GNO_STRUCT_SIZE(GnoLightGridItem, 8)
GNO_STRUCT_OFFSET(GnoLightGridItem, caster, 4)

struct GnoLightGridHeader {  // std430, 52 bytes
    uint groupsOfPairs;      //  0  indirect dispatch over the pairs of cell and caster: (groups, 1, 1)
    uint one0;
    uint one1;
    uint nests;              // 12  cells that are to be nested; what finds no room for its sub cells stays one list
    uint groupsOfLists;      // 16  indirect dispatch over the lists
    uint one2;
    uint one3;
    uint items;              // 28  of all lists; more than the pool holds: the lists are not complete, grow the pool and build again
    uint emitted;            // 32  items that were put, or found the pool full; as many as items, and none is missing
    uint groups;             // 36  of 64 lists each
    uint finished;           // 40  of these, sorted
    uint state;              // 44  finish, when all are: the word of core/state.h, GNO_STATE_ANY
    uint planes;             // 48  planes: the same word, where queries use them
};
GNO_STRUCT_SIZE(GnoLightGridHeader, 52)
GNO_STRUCT_OFFSET(GnoLightGridHeader, items, 28)
GNO_STRUCT_OFFSET(GnoLightGridHeader, state, 44)

// The word of core/state.h for a query, with planes or without.
GNO_INLINE uint gnoLightGridState(GnoLightGridHeader header_, bool planes_) {
    return planes_ && header_.planes != gnoState(GNO_STATE_ANY) ? 0u : header_.state;
}

GNO_INLINE uint gnoLightGridFirstSub(uint cells_) { return (cells_ + GNO_LIGHT_GRID_GROUP - 1u) / GNO_LIGHT_GRID_GROUP * GNO_LIGHT_GRID_GROUP; }
GNO_INLINE uint gnoLightGridLists(uint cells_, uint nests_) { return gnoLightGridFirstSub(cells_) + GNO_LIGHT_GRID_GROUP * nests_; }

GNO_NAMESPACE_END
#endif
