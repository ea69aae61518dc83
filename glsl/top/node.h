// SPDX-License-Identifier: MIT
// gnomon top/node.h : how a TOP tree lies in memory; read by glslang and by C++20 (namespace gno).
// After Mora, Gerhards, Aveneau, Ghazanfarpour, "Deep Partitioned Shadow Volumes Using Stackless and Hybrid Traversals", EGSR 2016,
// section 3.6 (four consecutive nodes per shadow volume, the negative child is the next node, 128 bytes per caster).
//
//   uint gnoTopState(GnoTopHeader header)      the word of core/state.h: may this tree be asked?
//
// Space      planes in the coordinates of gnoFromLight (core/light.glsl)
// Stages     any
// Requires   #version 450, no extension
//
// Caster c owns nodes 4c .. 4c+3: three shadow planes through the light and edges ab, bc, ca, then its capping plane. Nothing is allocated:
// the place of a node follows from its caster. The 32 bytes of a node lie in two arrays of 16, so that one binding of 128 MiB
// holds 2,097,152 casters, and what never changes is apart from what the build changes.
//
//   array    bytes        written by                       read by
//   planes   64 n         set-up                           build, queries; or there are none, and both compute them anew (GNO_TOP_STORE_PLANES 0 in
//   build.glsl)
//   links    64 n         set-up; build (atomics only)     build (atomics only), queries
//   slabs    64 n         set-up; build (atomics only)     queries; only where there are any (GNO_TOP_SLABS in build.glsl)
//   header   16           set-up; build (atomics only)     queries
//
// GnoTopLink::aux holds one thing per volume, by the node's place in it:
//   0  least depth of the casters in this subtree, float bits (gnoLightDepth, a lower bound; build: atomicMin)
//   1  ancestor: the node whose intersection subtree this volume stands in, GNO_TOP_NONE in none (section 3.4)
//   2  bits 0..1: facing + 1 (gnoFacing), 1: the caster is left out; bits 2..4: lateral plane 0..2 is a substitute (plane.glsl, 8)
//   3  reach: the caster's largest gnoLightScale, float bits
//
// A shader that builds says which pass it is, before bindings.glsl and build.glsl: #define GNO_TOP_BUILDS GNO_TOP_PASS_SET_UP; two with |, all: 1.
#ifndef GNO_TOP_NODE_H
#define GNO_TOP_NODE_H
#include "../core/state.h"
#define GNO_TOP_PASS_SET_UP 2  // gnoTopSetUp writes planes, links and slabs, its caller the header
#define GNO_TOP_PASS_BUILD 4   // gnoTopInsert writes links, slabs and the header, or whatever holds the root
GNO_NAMESPACE_BEGIN

GNO_CONST uint GNO_TOP_NONE = 0xFFFFFFFFu;  // no child, no ancestor, empty tree
GNO_CONST uint GNO_TOP_IN_SHADOW = 0xFFFFFFFEu;  // in place of a root (GNO_TOP_FIND_ROOT): the point is in shadow, no tree need be asked

GNO_CONST uint GNO_TOP_SUBSTITUTE = 4u;     // << place, in the aux of a volume's third node
GNO_CONST uint GNO_TOP_SUBSTITUTES = 28u;   // any of them

struct GnoTopLink {          // std430, 16 bytes
    uint positiveChild;      //  0  GNO_TOP_NONE when absent
    uint intersectionChild;  //  4
    uint aux;                //  8  see the table above
    uint wedge;              // 12  bounds of the intersection child's volumes, see gnoTopWedge in plane.glsl
};
GNO_STRUCT_SIZE(GnoTopLink, 16)
GNO_STRUCT_OFFSET(GnoTopLink, intersectionChild, 4)
GNO_STRUCT_OFFSET(GnoTopLink, aux, 8)
GNO_STRUCT_OFFSET(GnoTopLink, wedge, 12)

struct GnoTopHeader {        // std430, 16 bytes
    uint root;               //  0  GNO_TOP_NONE: an empty tree, everything is lit
    uint casterCount;        //  4  insertions that make it whole
    uint state;              //  8  set-up: gnoState(precision); other words: no tree (core/state.h)
    uint inserted;           // 12  build: insertions that were begun; as many as casterCount, and the tree is built
};
GNO_STRUCT_SIZE(GnoTopHeader, 16)
GNO_STRUCT_OFFSET(GnoTopHeader, state, 8)

// The word of core/state.h: of a tree whose build was left out, or done twice without a set-up between, it is 0.
GNO_INLINE uint gnoTopState(GnoTopHeader header_) { return header_.inserted == header_.casterCount ? header_.state : 0u; }

// std430, 16 bytes: what a node knows of its children, so that one which cannot matter is not loaded; bounds as in plane.glsl, 9
struct GnoTopSlab {
    uint positive;           //  0  the positive child's volumes lie between two numbers: gnoTopPositive. Unused in a cap
    uint negative;           //  4  float bits of gnoTopNegative over the owner and all behind its next plane. Unused in a cap
    uint positiveDepth;      //  8  least depth of the casters in the positive child, float bits
    uint intersectionDepth;  // 12  and in the intersection child
};
GNO_STRUCT_SIZE(GnoTopSlab, 16)
GNO_STRUCT_OFFSET(GnoTopSlab, negative, 4)
GNO_STRUCT_OFFSET(GnoTopSlab, positiveDepth, 8)
GNO_STRUCT_OFFSET(GnoTopSlab, intersectionDepth, 12)

struct GnoTopNode {          // a value: one node as a query sees it
    vec4 plane;              // xyz normal towards the positive side, w offset; in the coordinates of gnoFromLight
    uint positiveChild;
    uint intersectionChild;
    uint aux;
    uint wedge;
};

#ifdef __cplusplus
inline constexpr uint kTopGroupSize = 64;  ///< invocations per work group of set-up and build
constexpr std::uint64_t topPlaneBytes(std::uint64_t casterCount) { return 64 * (casterCount > 0 ? casterCount : 1); }
constexpr std::uint64_t topLinkBytes(std::uint64_t casterCount) { return 64 * (casterCount > 0 ? casterCount : 1); }
constexpr std::uint64_t topSlabBytes(std::uint64_t casterCount) { return 64 * (casterCount > 0 ? casterCount : 1); }
constexpr std::uint64_t topTreeBytes(std::uint64_t casterCount) {
    return topPlaneBytes(casterCount) + topLinkBytes(casterCount) + sizeof(GnoTopHeader);
}
#endif

GNO_NAMESPACE_END
#endif
