// SPDX-License-Identifier: MIT
// gnomon rivals/light_grid_bindings.glsl : our buffers of the lists; leave it out and define the macros yourself where your storage differs.
//
// Defines    GNO_LIGHT_GRID_STATE, GNO_LIGHT_GRID_LISTS, GNO_LIGHT_GRID_ITEMS, GNO_LIGHT_GRID_CAPACITY, GNO_LIGHT_GRID_HEADER,
//            GNO_LIGHT_GRID_LOAD_PLANE(index); in a shader that builds also GNO_LIGHT_GRID_DEPTHS and GNO_LIGHT_GRID_NESTS
// Space      as light_grid.h
// Stages     any with storage buffers; queries need no device feature, a build writes (fragment stage: fragmentStoresAndAtomics)
// Requires   #version 450, no extension. Include before the files of light_grid that use it
//
// Macro                          required  default  meaning
// GNO_LIGHT_GRID_SET             no        1        descriptor set of all five
// GNO_LIGHT_GRID_BINDING_LISTS   no        0        GnoLightGridList[gnoLightGridLists]
// GNO_LIGHT_GRID_BINDING_ITEMS   no        1        GnoLightGridItem[capacity]; its length is the capacity
// GNO_LIGHT_GRID_BINDING_DEPTHS  no        2        uint[64 nests]; its length says how many cells may be nested
// GNO_LIGHT_GRID_BINDING_HEADER  no        3        GnoLightGridHeader[], one but for several lights
// GNO_LIGHT_GRID_BINDING_PLANES  no        4        vec4[4 n], where queries use planes
// GNO_LIGHT_GRID_BUILDS          no        0        0: lists, items, header and planes, readonly; a shader that builds says here which pass it is
//                                                   (light_grid.h), has depths as well, and may write what this pass writes
// GNO_LIGHT_GRID_FIRST_HEADER    no        0u       queries: which header belongs to the lists that are asked; those of several lights may lie in
//                                                   the same buffers (README, "Several lights")
// GNO_LIGHT_GRID_FIRST_PLANE     no        0u       the same for planes: where this light's begin
#ifdef GNO_RIVALS_LIGHT_GRID_BINDINGS_GLSL
#error "rivals/light_grid_bindings.glsl: a second inclusion changes nothing; several lights: GNO_LIGHT_GRID_FIRST_LIST"
#endif
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
#ifdef GNO_LIGHT_GRID_READ_ONLY
#error "rivals/light_grid_bindings.glsl: readonly is the default now: delete GNO_LIGHT_GRID_READ_ONLY"
#endif
#ifndef GNO_LIGHT_GRID_BUILDS
#define GNO_LIGHT_GRID_BUILDS 0
#endif
#if GNO_LIGHT_GRID_BUILDS
#ifdef GNO_LIGHT_GRID_FIRST_LIST
#error "rivals/light_grid_bindings.glsl: GNO_LIGHT_GRID_FIRST_LIST is for queries; a build gets its part by the offsets of its descriptors"
#endif
#ifdef GNO_LIGHT_GRID_FIRST_ITEM
#error "rivals/light_grid_bindings.glsl: GNO_LIGHT_GRID_FIRST_ITEM is for queries; a build gets its part by the offsets of its descriptors"
#endif
#endif
#ifndef GNO_LIGHT_GRID_FIRST_HEADER
#define GNO_LIGHT_GRID_FIRST_HEADER 0u
#endif
#ifndef GNO_LIGHT_GRID_FIRST_PLANE
#define GNO_LIGHT_GRID_FIRST_PLANE 0u
#endif
#if (GNO_LIGHT_GRID_BUILDS) & (1 | GNO_LIGHT_GRID_PASS_OPEN | GNO_LIGHT_GRID_PASS_COUNT | GNO_LIGHT_GRID_PASS_ALLOCATE | GNO_LIGHT_GRID_PASS_EMIT)
#define GNO_LIGHT_GRID_LISTS_ACCESS_
#else
#define GNO_LIGHT_GRID_LISTS_ACCESS_ readonly
#endif
// the sort alone reads in one invocation what another one wrote
#if (GNO_LIGHT_GRID_BUILDS) & (1 | GNO_LIGHT_GRID_PASS_SORT)
#define GNO_LIGHT_GRID_ITEMS_ACCESS_ coherent
#elif (GNO_LIGHT_GRID_BUILDS) & GNO_LIGHT_GRID_PASS_EMIT
#define GNO_LIGHT_GRID_ITEMS_ACCESS_
#else
#define GNO_LIGHT_GRID_ITEMS_ACCESS_ readonly
#endif
#if (GNO_LIGHT_GRID_BUILDS) & (1 | GNO_LIGHT_GRID_PASS_PLANES)
#define GNO_LIGHT_GRID_PLANES_ACCESS_
#else
#define GNO_LIGHT_GRID_PLANES_ACCESS_ readonly
#endif

layout(set = GNO_LIGHT_GRID_SET, binding = GNO_LIGHT_GRID_BINDING_LISTS, std430) GNO_LIGHT_GRID_LISTS_ACCESS_ buffer GnoLightGridListBuffer {
    GnoLightGridList v[];
}
gnoGridLists;
layout(set = GNO_LIGHT_GRID_SET, binding = GNO_LIGHT_GRID_BINDING_ITEMS, std430) GNO_LIGHT_GRID_ITEMS_ACCESS_ buffer GnoLightGridItemBuffer {
    GnoLightGridItem v[];
}
gnoGridItems;
layout(set = GNO_LIGHT_GRID_SET, binding = GNO_LIGHT_GRID_BINDING_PLANES, std430) GNO_LIGHT_GRID_PLANES_ACCESS_ buffer GnoLightGridPlaneBuffer {
    vec4 v[];
}
gnoGridPlanes;
#if (GNO_LIGHT_GRID_BUILDS) & (1 | GNO_LIGHT_GRID_PASS_RESET | GNO_LIGHT_GRID_PASS_OPEN | GNO_LIGHT_GRID_PASS_SIZES | \
    GNO_LIGHT_GRID_PASS_ALLOCATE | GNO_LIGHT_GRID_PASS_EMIT | GNO_LIGHT_GRID_PASS_SORT | GNO_LIGHT_GRID_PASS_PLANES)
#define GNO_LIGHT_GRID_HEADER_ACCESS_
#else
#define GNO_LIGHT_GRID_HEADER_ACCESS_ readonly
#endif
layout(set = GNO_LIGHT_GRID_SET, binding = GNO_LIGHT_GRID_BINDING_HEADER, std430) GNO_LIGHT_GRID_HEADER_ACCESS_ buffer GnoLightGridHeaderBuffer {
    GnoLightGridHeader v[];
}
gnoGridHeader;
#if GNO_LIGHT_GRID_BUILDS
#if (GNO_LIGHT_GRID_BUILDS) & (1 | GNO_LIGHT_GRID_PASS_OPEN | GNO_LIGHT_GRID_PASS_DEPTH)
#define GNO_LIGHT_GRID_DEPTHS_ACCESS_
#else
#define GNO_LIGHT_GRID_DEPTHS_ACCESS_ readonly
#endif
layout(set = GNO_LIGHT_GRID_SET, binding = GNO_LIGHT_GRID_BINDING_DEPTHS, std430) GNO_LIGHT_GRID_DEPTHS_ACCESS_ buffer GnoLightGridDepthBuffer {
    uint v[];
}
gnoGridDepths;
#define GNO_LIGHT_GRID_DEPTHS gnoGridDepths.v
#define GNO_LIGHT_GRID_NESTS (uint(gnoGridDepths.v.length()) / GNO_LIGHT_GRID_GROUP)
#endif
#define GNO_LIGHT_GRID_HEADER gnoGridHeader.v[GNO_LIGHT_GRID_FIRST_HEADER]
#define GNO_LIGHT_GRID_STATE gnoLightGridState(GNO_LIGHT_GRID_HEADER, GNO_LIGHT_GRID_PLANES != 0)
#define GNO_LIGHT_GRID_LISTS gnoGridLists.v
#define GNO_LIGHT_GRID_ITEMS gnoGridItems.v
#define GNO_LIGHT_GRID_LOAD_PLANE(index_) gnoGridPlanes.v[GNO_LIGHT_GRID_FIRST_PLANE + (index_)]
#define GNO_LIGHT_GRID_CAPACITY uint(gnoGridItems.v.length())
#endif
