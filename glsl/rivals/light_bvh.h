// SPDX-License-Identifier: MIT
// gnomon rivals/light_bvh.h : a bounding volume hierarchy over the casters as the light sees them; read by glslang and by C++20 (namespace gno).
//
//   uint gnoLightBvhGroups(uint count)         work groups of GNO_LIGHT_BVH_GROUP
//   uint gnoLightBvhNodes(uint references)     the most nodes that a hierarchy over so many references has
//   uint gnoLightBvhNextRow(uint boxes)        boxes of the row above a row
//   uint gnoLightBvhBoxes(uint references)     boxes of all rows
//
// Point light: a tree for each face of a cube around it. Directional light: one tree. A reference is a caster on one face. Its bounds are cells of
// forest/cells.h at GNO_LIGHT_BVH_RESOLUTION, columns and rows both ends included, and the least depth.
//
//   array        bytes                                       written by          read by
//   grid         48                                          the host            all
//   masks        4 per triangle                              count               emit
//   sums         4 gnoLightBvhGroups(triangles)              count, begin        emit
//   header       64                                          count, begin, emit, split, collapse      all
//   levels       20 GNO_LIGHT_BVH_LEVELS                     begin, split, collapse       collapse
//   references   16 n                                        emit                leaves
//   keys, order  4 n each, twice                             emit, sort          sort, leaves, split
//   boxes        16 gnoLightBvhBoxes(n)                      leaves, up          up, split, collapse
//   splits       16 n                                        split               collapse
//   nodes        64 gnoLightBvhNodes(n)                      split, collapse     queries
//   parents      4 gnoLightBvhNodes(n)                       split, collapse     queries
//
// with n references. All but grid, header, nodes and parents are the build's own and may be thrown away after it.
//
// Space      light coordinates, q = gnoFromLight(p) (core/light.glsl)
// Stages     any
// Requires   #version 450, no extension
//
// A shader that builds says which pass it is, before light_bvh_bindings.glsl: #define GNO_LIGHT_BVH_BUILDS GNO_LIGHT_BVH_PASS_COUNT; several with |,
// all: 1.
#ifndef GNO_RIVALS_LIGHT_BVH_H
#define GNO_RIVALS_LIGHT_BVH_H
#include "../core/state.h"
#define GNO_LIGHT_BVH_PASS_COUNT 2      // writes masks, sums, header
#define GNO_LIGHT_BVH_PASS_BEGIN 4      // sums, header, levels
#define GNO_LIGHT_BVH_PASS_EMIT 8       // references, keys, order, header
#define GNO_LIGHT_BVH_PASS_LEAVES 16    // boxes
#define GNO_LIGHT_BVH_PASS_UP 32        // boxes
#define GNO_LIGHT_BVH_PASS_SPLIT 64     // splits, nodes, parents, header, levels
#define GNO_LIGHT_BVH_PASS_COLLAPSE 128 // nodes, parents, levels, header
GNO_NAMESPACE_BEGIN

GNO_CONST uint GNO_LIGHT_BVH_RESOLUTION = 32768u;    // cells along an edge of a face: 15 bits, and one to spare
GNO_CONST uint GNO_LIGHT_BVH_GROUP = 64u;            // invocations per work group of the build
GNO_CONST uint GNO_LIGHT_BVH_LEVELS = 56u;           // a path has at most 32 splits by a key's bits and 22 by an index's
GNO_CONST uint GNO_LIGHT_BVH_FAN = 8u;               // boxes under one of the next row

// A link: an inner node's index, or a leaf: this bit, the caster's facing and its index.
GNO_CONST uint GNO_LIGHT_BVH_NONE = 0xFFFFFFFFu;     // no root, no child, no parent
GNO_CONST uint GNO_LIGHT_BVH_LEAF = 0x80000000u;
GNO_CONST uint GNO_LIGHT_BVH_POSITIVE = 0x40000000u; // of a leaf: gnoFacing is 1, otherwise -1
GNO_CONST uint GNO_LIGHT_BVH_CASTER = 0x3FFFFFFFu;   // mask

struct GnoLightBvhBox {    // std430, 16 bytes
    uint low;              //  0  first column, first row << 16; the highest bit of either half is 0
    uint high;             //  4  last column, last row << 16; the same
    float least;           //  8  lower bound of gnoLightDepth over all casters in it
    uint link;             // 12  reference: its leaf's link; of `splits`: the last leaf of the first child, and the two bits below
};
GNO_STRUCT_SIZE(GnoLightBvhBox, 16)
GNO_STRUCT_OFFSET(GnoLightBvhBox, link, 12)

GNO_CONST uint GNO_LIGHT_BVH_FIRST_IS_LEAF = 0x80000000u;
GNO_CONST uint GNO_LIGHT_BVH_SECOND_IS_LEAF = 0x40000000u;

struct GnoLightBvhNode {   // std430, 64 bytes: four children; absent ones hold no cell and come last
    uvec4 low;             //  0
    uvec4 high;            // 16
    vec4 least;            // 32
    uvec4 link;            // 48
};
GNO_STRUCT_SIZE(GnoLightBvhNode, 64)
GNO_STRUCT_OFFSET(GnoLightBvhNode, least, 32)
GNO_STRUCT_OFFSET(GnoLightBvhNode, link, 48)

struct GnoLightBvhHeader { // std430, 64 bytes
    uint groupsOfReferences;  //  0  indirect dispatch over the references: (groups, 1, 1)
    uint one0;
    uint one1;
    uint references;       // 12  more than the pool holds: the tree is not complete, grow the pool and build again
    uint groupsOfTiles;    // 16  indirect dispatch over the tiles of core/radix_sort.h
    uint one2;
    uint one3;
    uint roots[6];         // 28  of each face, GNO_LIGHT_BVH_NONE: no caster there
    uint emitted;          // 52  references that were put, or found the pool full; as many as references, and none is missing
    uint leaves;           // 56  of the nodes that are done
    uint state;            // 60  collapse, when all are: the word of core/state.h, GNO_STATE_ANY
};
GNO_STRUCT_SIZE(GnoLightBvhHeader, 64)
GNO_STRUCT_OFFSET(GnoLightBvhHeader, groupsOfTiles, 16)
GNO_STRUCT_OFFSET(GnoLightBvhHeader, roots, 28)
GNO_STRUCT_OFFSET(GnoLightBvhHeader, state, 60)

struct GnoLightBvhLevel {  // std430, 20 bytes: the nodes of one depth stand side by side
    uint groups;           //  0  indirect dispatch: (groups, 1, 1)
    uint one0;
    uint one1;
    uint count;            // 12
    uint first;            // 16
};
GNO_STRUCT_SIZE(GnoLightBvhLevel, 20)

GNO_INLINE uint gnoLightBvhGroups(uint count_) { return (count_ + GNO_LIGHT_BVH_GROUP - 1u) / GNO_LIGHT_BVH_GROUP; }

// A node with fewer than four children has leaves only, so n leaves under a root have at most max(1, (2n - 1) / 3) nodes (by induction), on six
// faces in all this many.
GNO_INLINE uint gnoLightBvhNodes(uint references_) { return 2u * (references_ / 3u) + 8u; }

// Boxes of a row, and of all rows: row 0 are the sorted references, each next one has a box for GNO_LIGHT_BVH_FAN of those before.
GNO_INLINE uint gnoLightBvhNextRow(uint boxes_) { return (boxes_ + GNO_LIGHT_BVH_FAN - 1u) / GNO_LIGHT_BVH_FAN; }
GNO_INLINE uint gnoLightBvhBoxes(uint references_) {
    uint all_ = references_;
    uint row_ = references_;
    while (row_ > 1u) {
        row_ = gnoLightBvhNextRow(row_);
        all_ += row_;
    }
    return all_;
}

GNO_NAMESPACE_END
#endif
