// SPDX-License-Identifier: MIT
// gnomon rivals/light_bvh_bindings.glsl : our buffers of a light-space hierarchy; leave it out and define the macros yourself where your storage
// differs.
//
// Defines    GNO_LIGHT_BVH_GRID, GNO_LIGHT_BVH_ROOT, GNO_LIGHT_BVH_LOAD_NODE, GNO_LIGHT_BVH_LOAD_PARENT; with GNO_LIGHT_BVH_BUILD 1 also
//            GNO_LIGHT_BVH_MASKS,
//            GNO_LIGHT_BVH_SUMS, GNO_LIGHT_BVH_HEADER, GNO_LIGHT_BVH_LEVEL_TABLE, GNO_LIGHT_BVH_REFERENCES, GNO_LIGHT_BVH_CAPACITY,
//            GNO_LIGHT_BVH_KEYS,
//            GNO_LIGHT_BVH_ORDER, GNO_LIGHT_BVH_BOXES, GNO_LIGHT_BVH_SPLITS, GNO_LIGHT_BVH_NODES, GNO_LIGHT_BVH_PARENTS
// Space      as light_bvh.h
// Stages     any with storage buffers
// Requires   #version 450, no extension. Include before light_bvh_build.glsl or light_bvh_query.glsl
//
// Macro                             required  default  meaning
// GNO_LIGHT_BVH_SET                 no        1        descriptor set of all
// GNO_LIGHT_BVH_BINDING_GRID        no        0        uniform buffer: GnoForestGrid
// GNO_LIGHT_BVH_BINDING_HEADER      no        1        GnoLightBvhHeader
// GNO_LIGHT_BVH_BINDING_NODES       no        2        GnoLightBvhNode[gnoLightBvhNodes(capacity)]
// GNO_LIGHT_BVH_BINDING_PARENTS     no        3        uint[gnoLightBvhNodes(capacity)]
// GNO_LIGHT_BVH_BUILD               no        0        1: the arrays of the build as well; 0: the four above are read only
// GNO_LIGHT_BVH_BINDING_MASKS       no        4        uint[triangles]
// GNO_LIGHT_BVH_BINDING_SUMS        no        5        uint[gnoLightBvhGroups(triangles)]
// GNO_LIGHT_BVH_BINDING_LEVELS      no        6        GnoLightBvhLevel[GNO_LIGHT_BVH_LEVELS]
// GNO_LIGHT_BVH_BINDING_REFERENCES  no        7        GnoLightBvhBox[capacity]; its length is the capacity
// GNO_LIGHT_BVH_BINDING_KEYS        no        8        uint[capacity]
// GNO_LIGHT_BVH_BINDING_ORDER       no        9        uint[capacity]
// GNO_LIGHT_BVH_BINDING_BOXES       no        10       GnoLightBvhBox[gnoLightBvhBoxes(capacity)]
// GNO_LIGHT_BVH_BINDING_SPLITS      no        11       GnoLightBvhBox[capacity]
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
#ifndef GNO_LIGHT_BVH_BUILD
#define GNO_LIGHT_BVH_BUILD 0
#endif
#if GNO_LIGHT_BVH_BUILD
#define GNO_LIGHT_BVH_ACCESS_
#else
#define GNO_LIGHT_BVH_ACCESS_ readonly
#endif

layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_GRID, std140) uniform GnoLightBvhGridBuffer { GnoForestGrid v; } gnoLightBvhGrid;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_HEADER, std430) GNO_LIGHT_BVH_ACCESS_ buffer GnoLightBvhHeaderBuffer {
    GnoLightBvhHeader v;
}
gnoLightBvhHeader;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_NODES, std430) GNO_LIGHT_BVH_ACCESS_ buffer GnoLightBvhNodeBuffer {
    GnoLightBvhNode v[];
}
gnoLightBvhNode;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_PARENTS, std430) GNO_LIGHT_BVH_ACCESS_ buffer GnoLightBvhParentBuffer { uint v[]; }
gnoLightBvhParents;

#define GNO_LIGHT_BVH_GRID gnoLightBvhGrid.v
#define GNO_LIGHT_BVH_ROOT(face_) gnoLightBvhHeader.v.roots[face_]
#define GNO_LIGHT_BVH_LOAD_NODE(index_) gnoLightBvhNode.v[index_]
#define GNO_LIGHT_BVH_LOAD_PARENT(index_) gnoLightBvhParents.v[index_]

#if GNO_LIGHT_BVH_BUILD
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
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_MASKS, std430) buffer GnoLightBvhMaskBuffer { uint v[]; } gnoLightBvhMasks;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_SUMS, std430) buffer GnoLightBvhSumBuffer { uint v[]; } gnoLightBvhSums;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_LEVELS, std430) buffer GnoLightBvhLevelBuffer { GnoLightBvhLevel v[]; }
gnoLightBvhLevels;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_REFERENCES, std430) buffer GnoLightBvhReferenceBuffer { GnoLightBvhBox v[]; }
gnoLightBvhReferences;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_KEYS, std430) buffer GnoLightBvhKeyBuffer { uint v[]; } gnoLightBvhKeys;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_ORDER, std430) buffer GnoLightBvhOrderBuffer { uint v[]; } gnoLightBvhOrder;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_BOXES, std430) buffer GnoLightBvhBoxBuffer { GnoLightBvhBox v[]; } gnoLightBvhBoxes_;
layout(set = GNO_LIGHT_BVH_SET, binding = GNO_LIGHT_BVH_BINDING_SPLITS, std430) buffer GnoLightBvhSplitBuffer { GnoLightBvhBox v[]; }
gnoLightBvhSplits;

#define GNO_LIGHT_BVH_MASKS gnoLightBvhMasks.v
#define GNO_LIGHT_BVH_SUMS gnoLightBvhSums.v
#define GNO_LIGHT_BVH_HEADER gnoLightBvhHeader.v
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
