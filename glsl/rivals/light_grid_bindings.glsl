// SPDX-License-Identifier: MIT
// gnomon rivals/light_grid_bindings.glsl : our buffers of the lists; leave it out and define the macros yourself where your storage differs.
//
// Defines    GNO_LIGHT_GRID_LISTS, GNO_LIGHT_GRID_ITEMS, GNO_LIGHT_GRID_CAPACITY, GNO_LIGHT_GRID_LOAD_PLANE(index); without GNO_LIGHT_GRID_READ_ONLY
//            also GNO_LIGHT_GRID_DEPTHS, GNO_LIGHT_GRID_NESTS and
//            GNO_LIGHT_GRID_HEADER
// Space      as light_grid.h
// Stages     any with storage buffers
// Requires   #version 450, no extension. Include before the files of light_grid that use it
//
// Macro                          required  default  meaning
// GNO_LIGHT_GRID_SET             no        1        descriptor set of all five
// GNO_LIGHT_GRID_BINDING_LISTS   no        0        GnoLightGridList[gnoLightGridLists]
// GNO_LIGHT_GRID_BINDING_ITEMS   no        1        GnoLightGridItem[capacity]; its length is the capacity
// GNO_LIGHT_GRID_BINDING_DEPTHS  no        2        uint[64 nests]; its length says how many cells may be nested
// GNO_LIGHT_GRID_BINDING_HEADER  no        3        GnoLightGridHeader
// GNO_LIGHT_GRID_BINDING_PLANES  no        4        vec4[4 n], where queries use planes
// GNO_LIGHT_GRID_READ_ONLY       no        0        1: queries only; lists and items are read-only, the others are not bound
#ifndef GNO_RIVALS_LIGHT_GRID_BINDINGS_GLSL
#define GNO_RIVALS_LIGHT_GRID_BINDINGS_GLSL
#include "light_grid.h"
#ifndef GNO_LIGHT_GRID_SET
#define GNO_LIGHT_GRID_SET 1
#endif
#ifndef GNO_LIGHT_GRID_BINDING_LISTS
#define GNO_LIGHT_GRID_BINDING_LISTS 0
#endif
#ifndef GNO_LIGHT_GRID_BINDING_ITEMS
#define GNO_LIGHT_GRID_BINDING_ITEMS 1
#endif
#ifndef GNO_LIGHT_GRID_BINDING_DEPTHS
#define GNO_LIGHT_GRID_BINDING_DEPTHS 2
#endif
#ifndef GNO_LIGHT_GRID_BINDING_HEADER
#define GNO_LIGHT_GRID_BINDING_HEADER 3
#endif
#ifndef GNO_LIGHT_GRID_BINDING_PLANES
#define GNO_LIGHT_GRID_BINDING_PLANES 4
#endif
#ifndef GNO_LIGHT_GRID_READ_ONLY
#define GNO_LIGHT_GRID_READ_ONLY 0
#endif

#if GNO_LIGHT_GRID_READ_ONLY
layout(set = GNO_LIGHT_GRID_SET, binding = GNO_LIGHT_GRID_BINDING_LISTS, std430) readonly buffer GnoLightGridListBuffer { GnoLightGridList v[]; }
gnoGridLists;
layout(set = GNO_LIGHT_GRID_SET, binding = GNO_LIGHT_GRID_BINDING_ITEMS, std430) readonly buffer GnoLightGridItemBuffer { GnoLightGridItem v[]; }
gnoGridItems;
layout(set = GNO_LIGHT_GRID_SET, binding = GNO_LIGHT_GRID_BINDING_PLANES, std430) readonly buffer GnoLightGridPlaneBuffer { vec4 v[]; }
gnoGridPlanes;
#else
layout(set = GNO_LIGHT_GRID_SET, binding = GNO_LIGHT_GRID_BINDING_PLANES, std430) buffer GnoLightGridPlaneBuffer { vec4 v[]; } gnoGridPlanes;
layout(set = GNO_LIGHT_GRID_SET, binding = GNO_LIGHT_GRID_BINDING_LISTS, std430) buffer GnoLightGridListBuffer { GnoLightGridList v[]; }
gnoGridLists;
layout(set = GNO_LIGHT_GRID_SET, binding = GNO_LIGHT_GRID_BINDING_ITEMS, std430) coherent buffer GnoLightGridItemBuffer { GnoLightGridItem v[]; }
gnoGridItems;
layout(set = GNO_LIGHT_GRID_SET, binding = GNO_LIGHT_GRID_BINDING_DEPTHS, std430) buffer GnoLightGridDepthBuffer { uint v[]; } gnoGridDepths;
layout(set = GNO_LIGHT_GRID_SET, binding = GNO_LIGHT_GRID_BINDING_HEADER, std430) buffer GnoLightGridHeaderBuffer { GnoLightGridHeader v; }
gnoGridHeader;
#define GNO_LIGHT_GRID_DEPTHS gnoGridDepths.v
#define GNO_LIGHT_GRID_NESTS (uint(gnoGridDepths.v.length()) / GNO_LIGHT_GRID_GROUP)
#define GNO_LIGHT_GRID_HEADER gnoGridHeader.v
#endif
#define GNO_LIGHT_GRID_LISTS gnoGridLists.v
#define GNO_LIGHT_GRID_ITEMS gnoGridItems.v
#define GNO_LIGHT_GRID_LOAD_PLANE(index_) gnoGridPlanes.v[index_]
#define GNO_LIGHT_GRID_CAPACITY uint(gnoGridItems.v.length())
#endif
