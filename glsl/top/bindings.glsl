// SPDX-License-Identifier: MIT
// gnomon top/bindings.glsl : our buffers for a TOP tree; the only file of the module with layout(set = ...).
//
//   GnoTopNode gnoTopLoadNode(uint index)     what GNO_TOP_LOAD_NODE(index) is then
//
// Defines    GNO_TOP_PLANES (not with GNO_TOP_BIND_PLANES 0), GNO_TOP_LINKS, GNO_TOP_HEADER (for build.glsl), GNO_TOP_SLABS and GNO_TOP_LOAD_SLAB
//            with GNO_TOP_BIND_SLABS 1; GNO_TOP_STATE, GNO_TOP_NODE_COUNT, GNO_TOP_ROOT, GNO_TOP_LOAD_NODE, GNO_TOP_LOAD_ANCESTOR,
//            GNO_TOP_LOAD_FLAGS (for the queries)
// Space      planes in the coordinates of gnoFromLight (core/light.glsl)
// Stages     any with storage buffers; queries need no device feature, a build writes (fragment stage: fragmentStoresAndAtomics)
// Requires   #version 450, no extension. Include before build.glsl or a query; leave it out where your storage differs. Where you give
//            GNO_TOP_STORE_PLANES or GNO_TOP_BIND_PLANES 0, the macros of the last four rows come before this file, too (core/bindings.glsl for the
//            casters)
//
// Macro                   required  default  meaning
// GNO_TOP_SET             no        1        descriptor set of all
// GNO_TOP_STORE_PLANES    no        1        0: planes are not kept, gnoTopLoadNode computes them from casters; may be a specialization constant
// GNO_TOP_BIND_PLANES     no        1        0: there is no binding for planes, they are not kept
// GNO_TOP_BINDING_PLANES  no        0        planes, std430 vec4[4 n]; layout of all in node.h
// GNO_TOP_BINDING_LINKS   no        1        links, std430 GnoTopLink[4 n]
// GNO_TOP_BINDING_HEADER  no        2        headers, std430 GnoTopHeader[]; one but for several lights
// GNO_TOP_BIND_SLABS      no        0        1: there is a binding for slabs, too
// GNO_TOP_BINDING_SLABS   no        3        slabs, std430 GnoTopSlab[4 n]; only with GNO_TOP_BIND_SLABS 1
// GNO_TOP_BUILDS          no        0        0: all are readonly; a shader that builds says here which pass it is (node.h), and what this pass
//                                            writes is writable
// GNO_TOP_FIRST_NODE      no        0u       queries: where this tree's part of planes, links and slabs begins, in nodes. Trees of several lights
//                                            may lie in the same buffers; this says which one is asked (README, "Several lights")
// GNO_TOP_FIRST_HEADER    no        0u       the same for headers
// GNO_TOP_CASTER_OF(block)  no      (block)  as build.glsl; for planes that are not kept
// GNO_LIGHT               no        -        as build.glsl; for planes that are not kept
// GNO_LOAD_CASTER(index)  no        -        as build.glsl; for planes that are not kept
// GNO_PRECISION           no        GNO_PRECISION_CERTIFIED  as build.glsl; for planes that are not kept
#ifdef GNO_TOP_BINDINGS_GLSL
#error "top/bindings.glsl: a second inclusion changes nothing; trees of several lights: GNO_TOP_FIRST_NODE"
#endif
#ifndef GNO_TOP_BINDINGS_GLSL
#define GNO_TOP_BINDINGS_GLSL
#include "node.h"
#ifndef GNO_TOP_BIND_PLANES
#define GNO_TOP_BIND_PLANES 1
#endif
#if !GNO_TOP_BIND_PLANES && !defined(GNO_TOP_STORE_PLANES)
#define GNO_TOP_STORE_PLANES 0
#endif
#ifdef GNO_TOP_STORE_PLANES
#include "plane.glsl"
#ifndef GNO_TOP_CASTER_OF
#define GNO_TOP_CASTER_OF(block_) (block_)
#endif
#ifndef GNO_PRECISION
#define GNO_PRECISION GNO_PRECISION_CERTIFIED
#endif
#endif
#ifndef GNO_TOP_SET
#define GNO_TOP_SET 1
#endif
#ifndef GNO_TOP_BINDING_PLANES
#define GNO_TOP_BINDING_PLANES 0
#endif
#ifndef GNO_TOP_BINDING_LINKS
#define GNO_TOP_BINDING_LINKS 1
#endif
#ifndef GNO_TOP_BINDING_HEADER
#define GNO_TOP_BINDING_HEADER 2
#endif
#ifndef GNO_TOP_BIND_SLABS
#define GNO_TOP_BIND_SLABS 0
#endif
#ifndef GNO_TOP_BINDING_SLABS
#define GNO_TOP_BINDING_SLABS 3
#endif
#ifdef GNO_TOP_READ_ONLY
#error "top/bindings.glsl: readonly is the default now: delete GNO_TOP_READ_ONLY"
#endif
#ifndef GNO_TOP_BUILDS
#define GNO_TOP_BUILDS 0
#endif
#if (GNO_TOP_BUILDS) && defined(GNO_TOP_FIRST_NODE)
#error "top/bindings.glsl: GNO_TOP_FIRST_NODE is for queries; a build gets its part of the buffers by the offsets of its descriptors"
#endif
#ifndef GNO_TOP_FIRST_NODE
#define GNO_TOP_FIRST_NODE 0u
#endif
#ifndef GNO_TOP_FIRST_HEADER
#define GNO_TOP_FIRST_HEADER 0u
#endif
#if (GNO_TOP_BUILDS) & (1 | GNO_TOP_PASS_SET_UP)
#define GNO_TOP_PLANES_ACCESS_
#else
#define GNO_TOP_PLANES_ACCESS_ readonly
#endif
#if (GNO_TOP_BUILDS) & (1 | GNO_TOP_PASS_SET_UP | GNO_TOP_PASS_BUILD)
#define GNO_TOP_LINKS_ACCESS_
#else
#define GNO_TOP_LINKS_ACCESS_ readonly
#endif
#if (GNO_TOP_BUILDS) & (1 | GNO_TOP_PASS_SET_UP | GNO_TOP_PASS_BUILD)
#define GNO_TOP_HEADER_ACCESS_
#else
#define GNO_TOP_HEADER_ACCESS_ readonly
#endif

#if GNO_TOP_BIND_PLANES
layout(set = GNO_TOP_SET, binding = GNO_TOP_BINDING_PLANES, std430) GNO_TOP_PLANES_ACCESS_ buffer GnoTopPlaneBuffer { vec4 v[]; } gnoTopPlanes;
#define GNO_TOP_PLANES gnoTopPlanes.v
#endif
layout(set = GNO_TOP_SET, binding = GNO_TOP_BINDING_LINKS, std430) GNO_TOP_LINKS_ACCESS_ buffer GnoTopLinkBuffer { GnoTopLink v[]; } gnoTopLinks;
layout(set = GNO_TOP_SET, binding = GNO_TOP_BINDING_HEADER, std430) GNO_TOP_HEADER_ACCESS_ buffer GnoTopHeaderBuffer {
    GnoTopHeader v[];
}
gnoTopHeader;
#if GNO_TOP_BIND_SLABS
layout(set = GNO_TOP_SET, binding = GNO_TOP_BINDING_SLABS, std430) GNO_TOP_LINKS_ACCESS_ buffer GnoTopSlabBuffer { GnoTopSlab v[]; } gnoTopSlabs;
#define GNO_TOP_SLABS gnoTopSlabs.v
#define GNO_TOP_LOAD_SLAB(index_) gnoTopSlabs.v[GNO_TOP_FIRST_NODE + (index_)]
#endif

#define GNO_TOP_LINKS gnoTopLinks.v
#define GNO_TOP_NODE_COUNT (uint(gnoTopLinks.v.length()) - GNO_TOP_FIRST_NODE)
#define GNO_TOP_HEADER gnoTopHeader.v[GNO_TOP_FIRST_HEADER]
#define GNO_TOP_ROOT GNO_TOP_HEADER.root
#define GNO_TOP_STATE gnoTopState(GNO_TOP_HEADER)

#define GNO_TOP_LOAD_ANCESTOR(index_) gnoTopLinks.v[GNO_TOP_FIRST_NODE + ((index_) & ~3u) + 1u].aux
#define GNO_TOP_LOAD_FLAGS(index_) gnoTopLinks.v[GNO_TOP_FIRST_NODE + ((index_) & ~3u) + 2u].aux

vec4 gnoTopLoadPlane_(uint index_) {
#ifdef GNO_TOP_STORE_PLANES
#if GNO_TOP_BIND_PLANES
    if (GNO_TOP_STORE_PLANES != 0) return gnoTopPlanes.v[GNO_TOP_FIRST_NODE + index_];
#endif
    return gnoTopPlane(GNO_LIGHT, GNO_LOAD_CASTER(GNO_TOP_CASTER_OF(index_ >> 2)), index_ & 3u, GNO_TOP_LOAD_FLAGS(index_), GNO_PRECISION);
#else
    return gnoTopPlanes.v[GNO_TOP_FIRST_NODE + index_];
#endif
}

GnoTopNode gnoTopLoadNode(uint index_) {
    GnoTopLink link_ = gnoTopLinks.v[GNO_TOP_FIRST_NODE + index_];
    return GnoTopNode(gnoTopLoadPlane_(index_), link_.positiveChild, link_.intersectionChild, link_.aux, link_.wedge);
}
#define GNO_TOP_LOAD_NODE(index_) gnoTopLoadNode(index_)
#endif
