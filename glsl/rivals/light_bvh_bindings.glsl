// SPDX-License-Identifier: MIT
// gnomon rivals/light_bvh_bindings.glsl : our buffers of a light-space hierarchy; leave it out and define the macros yourself where your storage
// differs.
//
// Defines    GNO_LIGHT_BVH_GRID, GNO_LIGHT_BVH_STATE, GNO_LIGHT_BVH_ROOT, GNO_LIGHT_BVH_LOAD_NODE, GNO_LIGHT_BVH_LOAD_PARENT; GNO_LIGHT_BVH_HEADER;
//            in a shader that builds also GNO_LIGHT_BVH_MASKS, GNO_LIGHT_BVH_SUMS, GNO_LIGHT_BVH_LEVEL_TABLE,
//            GNO_LIGHT_BVH_REFERENCES, GNO_LIGHT_BVH_CAPACITY, GNO_LIGHT_BVH_KEYS, GNO_LIGHT_BVH_ORDER, GNO_LIGHT_BVH_BOXES, GNO_LIGHT_BVH_SPLITS,
//            GNO_LIGHT_BVH_NODES, GNO_LIGHT_BVH_PARENTS
// Space      as light_bvh.h
// Stages     any with storage buffers; queries need no device feature, a build writes (fragment stage: fragmentStoresAndAtomics)
// Requires   #version 450, no extension. Include before light_bvh_build.glsl or light_bvh_query.glsl
//
// Macro                             required  default  meaning
// GNO_LIGHT_BVH_SET                 no        1        descriptor set of all
// GNO_LIGHT_BVH_BINDING_GRID        no        0        uniform buffer: GnoForestGrid
// GNO_LIGHT_BVH_BINDING_HEADER      no        1        GnoLightBvhHeader[], one but for several lights
// GNO_LIGHT_BVH_BINDING_NODES       no        2        GnoLightBvhNode[gnoLightBvhNodes(capacity)]
// GNO_LIGHT_BVH_BINDING_PARENTS     no        3        uint[gnoLightBvhNodes(capacity)]
// GNO_LIGHT_BVH_GRID                no        gnoLightBvhGrid.v  where it is given, there is no binding for it
// GNO_LIGHT_BVH_FIRST_NODE          no        0u       queries: where this hierarchy's nodes and parents begin; those of several lights may lie in
//                                                      the same buffers (README, "Several lights")
// GNO_LIGHT_BVH_FIRST_HEADER        no        0u       the same for headers
// GNO_LIGHT_BVH_BUILDS              no        0        0: the four above, readonly; a shader that builds says here which pass it is (light_bvh.h),
//                                                      has the arrays of the build as well, and may write what this pass writes
// GNO_LIGHT_BVH_BINDING_MASKS       no        4        uint[triangles]
// GNO_LIGHT_BVH_BINDING_SUMS        no        5        uint[gnoLightBvhGroups(triangles)]
// GNO_LIGHT_BVH_BINDING_LEVELS      no        6        GnoLightBvhLevel[GNO_LIGHT_BVH_LEVELS]
// GNO_LIGHT_BVH_BINDING_REFERENCES  no        7        GnoLightBvhBox[capacity]; its length is the capacity
// GNO_LIGHT_BVH_BINDING_KEYS        no        8        uint[capacity]
// GNO_LIGHT_BVH_BINDING_ORDER       no        9        uint[capacity]
// GNO_LIGHT_BVH_BINDING_BOXES       no        10       GnoLightBvhBox[gnoLightBvhBoxes(capacity)]
// GNO_LIGHT_BVH_BINDING_SPLITS      no        11       GnoLightBvhBox[capacity]
#ifdef GNO_RIVALS_LIGHT_BVH_BINDINGS_GLSL
#error "rivals/light_bvh_bindings.glsl: a second inclusion changes nothing; several lights: GNO_LIGHT_BVH_FIRST_NODE"
#endif
#ifndef GNO_RIVALS_LIGHT_BVH_BINDINGS_GLSL
#define GNO_RIVALS_LIGHT_BVH_BINDINGS_GLSL
#include "../forest/cells.h"
#include "light_bvh.h"
#ifndef GNO_LIGHT_BVH_SET
#define GNO_LIGHT_BVH_SET 1
#endif
#ifndef GNO_LIGHT_BVH_BINDING_GRID
#define GNO_LIGHT_BVH_BINDING_GRID 0
#endif
#ifndef GNO_LIGHT_BVH_BINDING_HEADER
#define GNO_LIGHT_BVH_BINDING_HEADER 1
#endif
#ifndef GNO_LIGHT_BVH_BINDING_NODES
#define GNO_LIGHT_BVH_BINDING_NODES 2
#endif
#ifndef GNO_LIGHT_BVH_BINDING_PARENTS
#define GNO_LIGHT_BVH_BINDING_PARENTS 3
#endif
#ifdef GNO_LIGHT_BVH_BUILD
#error "rivals/light_bvh_bindings.glsl: GNO_LIGHT_BVH_BUILD has an S behind it now and says which pass builds, as in light_bvh.h"
#endif
#ifndef GNO_LIGHT_BVH_BUILDS
#define GNO_LIGHT_BVH_BUILDS 0
#endif
#if (GNO_LIGHT_BVH_BUILDS) && defined(GNO_LIGHT_BVH_FIRST_NODE)
#error "rivals/light_bvh_bindings.glsl: GNO_LIGHT_BVH_FIRST_NODE is for queries; a build gets its part by the offsets of its descriptors"
#endif
#ifndef GNO_LIGHT_BVH_FIRST_NODE
#define GNO_LIGHT_BVH_FIRST_NODE 0u
#endif
#ifndef GNO_LIGHT_BVH_FIRST_HEADER
#define GNO_LIGHT_BVH_FIRST_HEADER 0u
#endif
#if (GNO_LIGHT_BVH_BUILDS) & (1 | GNO_LIGHT_BVH_PASS_COUNT | GNO_LIGHT_BVH_PASS_BEGIN | GNO_LIGHT_BVH_PASS_EMIT | GNO_LIGHT_BVH_PASS_SPLIT | \
    GNO_LIGHT_BVH_PASS_COLLAPSE)
#define GNO_LIGHT_BVH_HEADER_ACCESS_
#else
#define GNO_LIGHT_BVH_HEADER_ACCESS_ readonly
#endif
#if (GNO_LIGHT_BVH_BUILDS) & (1 | GNO_LIGHT_BVH_PASS_SPLIT | GNO_LIGHT_BVH_PASS_COLLAPSE)
#define GNO_LIGHT_BVH_NODES_ACCESS_
#else
#define GNO_LIGHT_BVH_NODES_ACCESS_ readonly
#endif

#ifndef GNO_LIGHT_BVH_GRID
#define GNO_LIGHT_BVH_GRID gnoLightBvhGrid.v
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_GRID, std140) uniform GnoLightBvhGridBuffer { GnoForestGrid v; } gnoLightBvhGrid;
#endif
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_HEADER, std430) GNO_LIGHT_BVH_HEADER_ACCESS_ buffer GnoLightBvhHeaderBuffer {
    GnoLightBvhHeader v[];
}
gnoLightBvhHeader;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_NODES, std430) GNO_LIGHT_BVH_NODES_ACCESS_ buffer GnoLightBvhNodeBuffer {
    GnoLightBvhNode v[];
}
gnoLightBvhNode;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_PARENTS, std430) GNO_LIGHT_BVH_NODES_ACCESS_ buffer GnoLightBvhParentBuffer {
    uint v[];
}
gnoLightBvhParents;

#define GNO_LIGHT_BVH_HEADER gnoLightBvhHeader.v[GNO_LIGHT_BVH_FIRST_HEADER]
#define GNO_LIGHT_BVH_STATE GNO_LIGHT_BVH_HEADER.state
#define GNO_LIGHT_BVH_ROOT(face_) GNO_LIGHT_BVH_HEADER.roots[face_]
#define GNO_LIGHT_BVH_LOAD_NODE(index_) gnoLightBvhNode.v[GNO_LIGHT_BVH_FIRST_NODE + (index_)]
#define GNO_LIGHT_BVH_LOAD_PARENT(index_) gnoLightBvhParents.v[GNO_LIGHT_BVH_FIRST_NODE + (index_)]

#if GNO_LIGHT_BVH_BUILDS
#ifndef GNO_LIGHT_BVH_BINDING_MASKS
#define GNO_LIGHT_BVH_BINDING_MASKS 4
#endif
#ifndef GNO_LIGHT_BVH_BINDING_SUMS
#define GNO_LIGHT_BVH_BINDING_SUMS 5
#endif
#ifndef GNO_LIGHT_BVH_BINDING_LEVELS
#define GNO_LIGHT_BVH_BINDING_LEVELS 6
#endif
#ifndef GNO_LIGHT_BVH_BINDING_REFERENCES
#define GNO_LIGHT_BVH_BINDING_REFERENCES 7
#endif
#ifndef GNO_LIGHT_BVH_BINDING_KEYS
#define GNO_LIGHT_BVH_BINDING_KEYS 8
#endif
#ifndef GNO_LIGHT_BVH_BINDING_ORDER
#define GNO_LIGHT_BVH_BINDING_ORDER 9
#endif
#ifndef GNO_LIGHT_BVH_BINDING_BOXES
#define GNO_LIGHT_BVH_BINDING_BOXES 10
#endif
#ifndef GNO_LIGHT_BVH_BINDING_SPLITS
#define GNO_LIGHT_BVH_BINDING_SPLITS 11
#endif
#if (GNO_LIGHT_BVH_BUILDS) & (1 | GNO_LIGHT_BVH_PASS_COUNT)
#define GNO_LIGHT_BVH_MASKS_ACCESS_
#else
#define GNO_LIGHT_BVH_MASKS_ACCESS_ readonly
#endif
#if (GNO_LIGHT_BVH_BUILDS) & (1 | GNO_LIGHT_BVH_PASS_COUNT | GNO_LIGHT_BVH_PASS_BEGIN)
#define GNO_LIGHT_BVH_SUMS_ACCESS_
#else
#define GNO_LIGHT_BVH_SUMS_ACCESS_ readonly
#endif
#if (GNO_LIGHT_BVH_BUILDS) & (1 | GNO_LIGHT_BVH_PASS_BEGIN | GNO_LIGHT_BVH_PASS_SPLIT | GNO_LIGHT_BVH_PASS_COLLAPSE)
#define GNO_LIGHT_BVH_LEVELS_ACCESS_
#else
#define GNO_LIGHT_BVH_LEVELS_ACCESS_ readonly
#endif
#if (GNO_LIGHT_BVH_BUILDS) & (1 | GNO_LIGHT_BVH_PASS_EMIT)
#define GNO_LIGHT_BVH_REFERENCES_ACCESS_
#else
#define GNO_LIGHT_BVH_REFERENCES_ACCESS_ readonly
#endif
#if (GNO_LIGHT_BVH_BUILDS) & (1 | GNO_LIGHT_BVH_PASS_LEAVES | GNO_LIGHT_BVH_PASS_UP)
#define GNO_LIGHT_BVH_BOXES_ACCESS_
#else
#define GNO_LIGHT_BVH_BOXES_ACCESS_ readonly
#endif
#if (GNO_LIGHT_BVH_BUILDS) & (1 | GNO_LIGHT_BVH_PASS_SPLIT)
#define GNO_LIGHT_BVH_SPLITS_ACCESS_
#else
#define GNO_LIGHT_BVH_SPLITS_ACCESS_ readonly
#endif

layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_MASKS, std430) GNO_LIGHT_BVH_MASKS_ACCESS_ buffer GnoLightBvhMaskBuffer { uint v[]; }
gnoLightBvhMasks;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_SUMS, std430) GNO_LIGHT_BVH_SUMS_ACCESS_ buffer GnoLightBvhSumBuffer { uint v[]; }
gnoLightBvhSums;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_LEVELS, std430) GNO_LIGHT_BVH_LEVELS_ACCESS_ buffer GnoLightBvhLevelBuffer {
    GnoLightBvhLevel v[];
}
gnoLightBvhLevels;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_REFERENCES, std430)
    GNO_LIGHT_BVH_REFERENCES_ACCESS_ buffer GnoLightBvhReferenceBuffer {
    GnoLightBvhBox v[];
}
gnoLightBvhReferences;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_KEYS, std430) GNO_LIGHT_BVH_REFERENCES_ACCESS_ buffer GnoLightBvhKeyBuffer {
    uint v[];
}
gnoLightBvhKeys;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_ORDER, std430) GNO_LIGHT_BVH_REFERENCES_ACCESS_ buffer GnoLightBvhOrderBuffer {
    uint v[];
}
gnoLightBvhOrder;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_BOXES, std430) GNO_LIGHT_BVH_BOXES_ACCESS_ buffer GnoLightBvhBoxBuffer {
    GnoLightBvhBox v[];
}
gnoLightBvhBoxes_;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_SPLITS, std430) GNO_LIGHT_BVH_SPLITS_ACCESS_ buffer GnoLightBvhSplitBuffer {
    GnoLightBvhBox v[];
}
gnoLightBvhSplits;

#define GNO_LIGHT_BVH_MASKS gnoLightBvhMasks.v
#define GNO_LIGHT_BVH_SUMS gnoLightBvhSums.v
#define GNO_LIGHT_BVH_LEVEL_TABLE gnoLightBvhLevels.v
#define GNO_LIGHT_BVH_REFERENCES gnoLightBvhReferences.v
#define GNO_LIGHT_BVH_CAPACITY uint(gnoLightBvhReferences.v.length())
#define GNO_LIGHT_BVH_KEYS gnoLightBvhKeys.v
#define GNO_LIGHT_BVH_ORDER gnoLightBvhOrder.v
#define GNO_LIGHT_BVH_BOXES gnoLightBvhBoxes_.v
#define GNO_LIGHT_BVH_SPLITS gnoLightBvhSplits.v
#define GNO_LIGHT_BVH_NODES gnoLightBvhNode.v
#define GNO_LIGHT_BVH_PARENTS gnoLightBvhParents.v
#endif
#endif
