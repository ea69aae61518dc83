// SPDX-License-Identifier: MIT
// gnomon forest/bindings.glsl : our buffers of a forest; leave it out and define the macros yourself where your storage differs.
//
// Defines    GNO_FOREST_GRID, GNO_FOREST_CELLS, GNO_FOREST_FEW, GNO_FOREST_PAIRS, GNO_FOREST_CAPACITY, GNO_FOREST_HEADER; with GNO_FOREST_TREES 1,
//            for glsl/top:
//            GNO_TOP_CASTER_OF, GNO_TOP_ROOT_OF, GNO_TOP_FIND_ROOT (that needs GNO_LIGHT where a query is used)
// Space      as cells.h
// Stages     any with storage buffers
// Requires   #version 450, no extension. Include before the files of glsl/top that use it
//
// Macro                       required  default  meaning
// GNO_FOREST_SET              no        3        descriptor set of all five
// GNO_FOREST_BINDING_GRID     no        0        uniform buffer: GnoForestGrid
// GNO_FOREST_BINDING_CELLS    no        1        GnoForestCell[gnoCellCount]
// GNO_FOREST_BINDING_PAIRS    no        2        GnoForestPair[capacity]; its length is the capacity
// GNO_FOREST_BINDING_HEADER   no        3        GnoForestHeader
// GNO_FOREST_BINDING_FEW      no        4        GnoForestFew[casters]
// GNO_FOREST_TREES            no        0        1: the build and the queries of glsl/top in this shader work on the forest, not on one tree
#ifndef GNO_FOREST_BINDINGS_GLSL
#define GNO_FOREST_BINDINGS_GLSL
#include "cells.h"
#ifndef GNO_FOREST_TREES
#define GNO_FOREST_TREES 0
#endif
#if GNO_FOREST_TREES
#include "cells.glsl"
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

layout(set = GNO_FOREST_SET, binding = GNO_FOREST_BINDING_GRID, std140) uniform GnoForestGridBuffer { GnoForestGrid v; } gnoForestGrid;
layout(set = GNO_FOREST_SET, binding = GNO_FOREST_BINDING_CELLS, std430) buffer GnoForestCellBuffer { GnoForestCell v[]; } gnoForestCells;
layout(set = GNO_FOREST_SET, binding = GNO_FOREST_BINDING_PAIRS, std430) buffer GnoForestPairBuffer { GnoForestPair v[]; } gnoForestPairs;
layout(set = GNO_FOREST_SET, binding = GNO_FOREST_BINDING_HEADER, std430) buffer GnoForestHeaderBuffer { GnoForestHeader v; } gnoForestHeader;
layout(set = GNO_FOREST_SET, binding = GNO_FOREST_BINDING_FEW, std430) buffer GnoForestFewBuffer { GnoForestFew v[]; } gnoForestFew;

#define GNO_FOREST_GRID gnoForestGrid.v
#define GNO_FOREST_CELLS gnoForestCells.v
#define GNO_FOREST_FEW gnoForestFew.v
#define GNO_FOREST_PAIRS gnoForestPairs.v
#define GNO_FOREST_CAPACITY uint(gnoForestPairs.v.length())
#define GNO_FOREST_HEADER gnoForestHeader.v
#if GNO_FOREST_TREES
#define GNO_TOP_CASTER_OF(block_) gnoForestPairs.v[block_].caster
#define GNO_TOP_ROOT_OF(block_) gnoForestCells.v[gnoForestPairs.v[block_].cell].root
#define GNO_TOP_FIND_ROOT(q_) gnoForestRoot(gnoForestCells.v[gnoCellOf(GNO_LIGHT, gnoForestGrid.v, q_)], gnoLightDepth(GNO_LIGHT, q_))
#endif
#endif
