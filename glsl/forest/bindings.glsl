// SPDX-License-Identifier: MIT
// gnomon forest/bindings.glsl : our buffers of a forest; leave it out and define the macros yourself where your storage differs.
//
// Defines    GNO_FOREST_GRID, GNO_FOREST_CELLS, GNO_FOREST_FEW, GNO_FOREST_PAIRS, GNO_FOREST_CAPACITY, GNO_FOREST_HEADER; with GNO_FOREST_TREES 1,
//            for glsl/top:
//            GNO_TOP_CASTER_OF, GNO_TOP_ROOT_OF, GNO_TOP_FIND_ROOT (that needs GNO_LIGHT where a query is used)
// Space      as cells.h
// Stages     any with storage buffers; queries need no device feature, a build writes (fragment stage: fragmentStoresAndAtomics)
// Requires   #version 450, no extension. Include before the files of glsl/top that use it
//
// Macro                       required  default  meaning
// GNO_FOREST_SET              no        3        descriptor set of all five
// GNO_FOREST_BINDING_GRID     no        0        uniform buffer: GnoForestGrid
// GNO_FOREST_BINDING_CELLS    no        1        GnoForestCell[gnoCellCount]
// GNO_FOREST_BINDING_PAIRS    no        2        GnoForestPair[capacity]; its length is the capacity
// GNO_FOREST_BINDING_HEADER   no        3        GnoForestHeader
// GNO_FOREST_BINDING_FEW      no        4        GnoForestFew[casters]
// GNO_FOREST_BUILDS           no        0        0: all are readonly; a shader that builds says here which pass it is (cells.h), and what this pass
//                                                writes is writable
// GNO_FOREST_TREES            no        -        1: the build and the queries of glsl/top in this shader work on the forest, 0: on one tree; needed
//                                                in a shader that includes any of them
// GNO_FOREST_GRID             no        gnoForestGrid.v  where it is given, there is no binding for it
// GNO_FOREST_FIRST_CELL       no        0u       queries: where this forest's part of the cells begins; forests of several lights may lie in the
//                                                same buffers (README, "Several lights")
// GNO_FOREST_FIRST_PAIR       no        0u       the same for pairs
#ifdef GNO_FOREST_BINDINGS_GLSL
#error "forest/bindings.glsl: a second inclusion changes nothing; forests of several lights: GNO_FOREST_FIRST_CELL"
#endif
#ifndef GNO_FOREST_BINDINGS_GLSL
#define GNO_FOREST_BINDINGS_GLSL
#include "cells.h"
#ifdef GNO_FOREST_TREES
#define GNO_FOREST_ASKED_ GNO_FOREST_TREES
#else
#define GNO_FOREST_ASKED_ 0
#define GNO_FOREST_UNDECIDED_
#endif
#if GNO_FOREST_ASKED_
#include "cells.glsl"
#ifdef GNO_TOP_INCLUDED_
#error "forest/bindings.glsl: with GNO_FOREST_TREES 1 it comes before the files of glsl/top that use it"
#endif
#endif
#ifndef GNO_FOREST_SET
#define GNO_FOREST_SET 3
#endif
#ifndef GNO_FOREST_BINDING_GRID
#define GNO_FOREST_BINDING_GRID 0
#endif
#ifndef GNO_FOREST_BINDING_CELLS
#define GNO_FOREST_BINDING_CELLS 1
#endif
#ifndef GNO_FOREST_BINDING_PAIRS
#define GNO_FOREST_BINDING_PAIRS 2
#endif
#ifndef GNO_FOREST_BINDING_HEADER
#define GNO_FOREST_BINDING_HEADER 3
#endif
#ifndef GNO_FOREST_BINDING_FEW
#define GNO_FOREST_BINDING_FEW 4
#endif
#ifndef GNO_FOREST_BUILDS
#define GNO_FOREST_BUILDS 0
#endif
#if (GNO_FOREST_BUILDS) && defined(GNO_FOREST_FIRST_CELL)
#error "forest/bindings.glsl: GNO_FOREST_FIRST_CELL is for queries; a build gets its part of the buffers by the offsets of its descriptors"
#endif
#if (GNO_FOREST_BUILDS) && defined(GNO_FOREST_FIRST_PAIR)
#error "forest/bindings.glsl: GNO_FOREST_FIRST_PAIR is for queries; a build gets its part of the buffers by the offsets of its descriptors"
#endif
#ifndef GNO_FOREST_FIRST_CELL
#define GNO_FOREST_FIRST_CELL 0u
#endif
#ifndef GNO_FOREST_FIRST_PAIR
#define GNO_FOREST_FIRST_PAIR 0u
#endif
#if (GNO_FOREST_BUILDS) & (1 | GNO_FOREST_PASS_RESET | GNO_FOREST_PASS_DEPTH | GNO_FOREST_PASS_COVER | GNO_FOREST_PASS_COUNT | \
    GNO_FOREST_PASS_ALLOCATE | GNO_FOREST_PASS_EMIT | GNO_FOREST_PASS_BUILD)
#define GNO_FOREST_CELLS_ACCESS_
#else
#define GNO_FOREST_CELLS_ACCESS_ readonly
#endif
#if (GNO_FOREST_BUILDS) & (1 | GNO_FOREST_PASS_EMIT)
#define GNO_FOREST_PAIRS_ACCESS_
#else
#define GNO_FOREST_PAIRS_ACCESS_ readonly
#endif
#if (GNO_FOREST_BUILDS) & (1 | GNO_FOREST_PASS_RESET | GNO_FOREST_PASS_SORT | GNO_FOREST_PASS_ALLOCATE | GNO_FOREST_PASS_SIZES | \
    GNO_FOREST_PASS_EMIT)
#define GNO_FOREST_HEADER_ACCESS_
#else
#define GNO_FOREST_HEADER_ACCESS_ readonly
#endif
#if (GNO_FOREST_BUILDS) & (1 | GNO_FOREST_PASS_SORT)
#define GNO_FOREST_FEW_ACCESS_
#else
#define GNO_FOREST_FEW_ACCESS_ readonly
#endif

#ifndef GNO_FOREST_GRID
#define GNO_FOREST_GRID gnoForestGrid.v
layout(set = GNO_FOREST_SET, binding = GNO_FOREST_BINDING_GRID, std140) uniform GnoForestGridBuffer { GnoForestGrid v; } gnoForestGrid;
#endif
layout(set = GNO_FOREST_SET, binding = GNO_FOREST_BINDING_CELLS, std430) GNO_FOREST_CELLS_ACCESS_ buffer GnoForestCellBuffer { GnoForestCell v[]; }
gnoForestCells;
layout(set = GNO_FOREST_SET, binding = GNO_FOREST_BINDING_PAIRS, std430) GNO_FOREST_PAIRS_ACCESS_ buffer GnoForestPairBuffer { GnoForestPair v[]; }
gnoForestPairs;
layout(set = GNO_FOREST_SET, binding = GNO_FOREST_BINDING_HEADER, std430) GNO_FOREST_HEADER_ACCESS_ buffer GnoForestHeaderBuffer {
    GnoForestHeader v;
}
gnoForestHeader;
layout(set = GNO_FOREST_SET, binding = GNO_FOREST_BINDING_FEW, std430) GNO_FOREST_FEW_ACCESS_ buffer GnoForestFewBuffer { GnoForestFew v[]; }
gnoForestFew;

#define GNO_FOREST_CELLS gnoForestCells.v
#define GNO_FOREST_FEW gnoForestFew.v
#define GNO_FOREST_PAIRS gnoForestPairs.v
#define GNO_FOREST_CAPACITY uint(gnoForestPairs.v.length())
#define GNO_FOREST_HEADER gnoForestHeader.v
#if GNO_FOREST_ASKED_
#define GNO_TOP_CASTER_OF(block_) gnoForestPairs.v[GNO_FOREST_FIRST_PAIR + (block_)].caster
#define GNO_TOP_ROOT_OF(block_) gnoForestCells.v[gnoForestPairs.v[block_].cell].root
#define GNO_TOP_FIND_ROOT(q_) \
    gnoForestRoot(gnoForestCells.v[GNO_FOREST_FIRST_CELL + gnoCellOf(GNO_LIGHT, GNO_FOREST_GRID, q_)], gnoLightDepth(GNO_LIGHT, q_))
#if !((GNO_FOREST_BUILDS) & (1 | GNO_FOREST_PASS_BUILD))
#define GNO_FOREST_ROOTS_READONLY_
#endif
#endif
#endif
