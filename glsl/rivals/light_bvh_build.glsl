// SPDX-License-Identifier: MIT
// gnomon rivals/light_bvh_build.glsl : a hierarchy over the casters of a light, built along a Morton curve.
// Binary hierarchy after Karras, "Maximizing Parallelism in the Construction of BVHs, Octrees, and k-d Trees", HPG 2012; opened to four children
// from the top.
//
//   void gnoLightBvhCount(uint caster, uint faces, uint group, uint invocation)             1: one invocation per triangle; gnoLightBvhFaces, or 0:
//   it casts nothing
//   void gnoLightBvhBegin(uint references)                                     2: one invocation, told the sum of all counts
//   uint gnoLightBvhFirst(uint faces, uint group, uint invocation)             3: as 1, with the same faces: where the caster's references begin
//   void gnoLightBvhEmit(uint caster, uint faces, GnoLightBvhCaster c, uint first)          3: writes them
//   (core/radix_sort.glsl over keys and order)                                 4
//   void gnoLightBvhLeaf(uint i)                                               5: one invocation per reference, in sorted order
//   void gnoLightBvhUp(uint row, uint i)                                       6: rows 1, 2 .. until one has a single box, a dispatch each
//   void gnoLightBvhSplit(uint i)                                              7: one invocation per reference
//   void gnoLightBvhCollapse(uint level, uint i)                               8: levels 0 .. GNO_LIGHT_BVH_LEVELS - 1, a dispatch each; most of
//   them are empty
//
// Between 1 and 2 the sums become prefix sums (core/prefix_sum.glsl). Each step is a dispatch of its own; what it reads was written in earlier ones.
// No step waits for another work group, and the only atomics are the allocation of nodes. The bounds of an inner node are the union over its range
// of the sorted references, taken from the rows of boxes:
// a few loads, no way up the tree, no order between invocations. The tree's shape depends on the casters alone; where its nodes lie depends on who
// came first.
//
// A pool that is too small is not overrun: header.references tells, and a query answers GNO_VISIBILITY_UNKNOWN. So it does until 8 is done, and
// where a step was left out and its gap was seen (core/state.h).
//
// Space      light coordinates
// Stages     compute with storage buffers; gnoLightBvhCount and gnoLightBvhFirst hold barriers: all GNO_LIGHT_BVH_GROUP invocations of the work
//            group call, in uniform control flow
// Requires   #version 450, no extension, any subgroup width
// Cost       8 rounds of sorting move 8 bytes per reference each; most of the 56 dispatches of the collapse are empty
//
// Macro                        required  default  meaning
// GNO_LIGHT_BVH_BUILDS         no        1        which steps this shader has: 1 GNO_LIGHT_BVH_PASS_COUNT, 2 .._BEGIN, 3 .._EMIT, 5 .._LEAVES,
//                                                 6 .._UP, 7 .._SPLIT, 8 .._COLLAPSE; several with |, 1 for all; light_bvh_bindings.glsl makes
//                                                 writable what they write
// GNO_LIGHT_BVH_GRID           yes       -        GnoForestGrid, resolution GNO_LIGHT_BVH_RESOLUTION
// GNO_LIGHT_BVH_MASKS          yes       -        arrays of light_bvh.h in storage buffers: masks
// GNO_LIGHT_BVH_SUMS           yes       -        sums
// GNO_LIGHT_BVH_HEADER         yes       -        GnoLightBvhHeader
// GNO_LIGHT_BVH_LEVEL_TABLE    yes       -        levels
// GNO_LIGHT_BVH_REFERENCES     yes       -        references
// GNO_LIGHT_BVH_CAPACITY       yes       -        references that the pool holds
// GNO_LIGHT_BVH_KEYS           yes       -        keys
// GNO_LIGHT_BVH_ORDER          yes       -        order
// GNO_LIGHT_BVH_BOXES          yes       -        boxes
// GNO_LIGHT_BVH_SPLITS         yes       -        splits
// GNO_LIGHT_BVH_NODES          yes       -        nodes
// GNO_LIGHT_BVH_PARENTS        yes       -        parents
// GNO_LIGHT                    yes       -        vec4, homogeneous (core/light.glsl)
#ifndef GNO_RIVALS_LIGHT_BVH_BUILD_GLSL
#define GNO_RIVALS_LIGHT_BVH_BUILD_GLSL
#include "../core/prefix_sum.glsl"
#include "../core/radix_sort.h"
#include "light_bvh_bounds.glsl"
#ifndef GNO_LIGHT_BVH_BUILDS
#define GNO_LIGHT_BVH_BUILDS 1
#endif
#if (GNO_LIGHT_BVH_BUILDS) == 0
#error "rivals/light_bvh_build.glsl: which pass is this? define GNO_LIGHT_BVH_BUILDS before light_bvh_bindings.glsl, as light_bvh.h says"
#endif
#if !defined(GNO_LIGHT_BVH_GRID) || !defined(GNO_LIGHT_BVH_MASKS)
#error "rivals/light_bvh_build.glsl: define GNO_LIGHT_BVH_GRID and GNO_LIGHT_BVH_MASKS (or include light_bvh_bindings.glsl for a build)"
#endif
#if !defined(GNO_LIGHT_BVH_SUMS) || !defined(GNO_LIGHT_BVH_HEADER)
#error "rivals/light_bvh_build.glsl: define GNO_LIGHT_BVH_SUMS and GNO_LIGHT_BVH_HEADER (or include light_bvh_bindings.glsl for a build)"
#endif
#if !defined(GNO_LIGHT_BVH_LEVEL_TABLE) || !defined(GNO_LIGHT_BVH_REFERENCES)
#error "rivals/light_bvh_build.glsl: define GNO_LIGHT_BVH_LEVEL_TABLE and GNO_LIGHT_BVH_REFERENCES (or include light_bvh_bindings.glsl for a build)"
#endif
#if !defined(GNO_LIGHT_BVH_CAPACITY) || !defined(GNO_LIGHT_BVH_KEYS)
#error "rivals/light_bvh_build.glsl: define GNO_LIGHT_BVH_CAPACITY and GNO_LIGHT_BVH_KEYS (or include light_bvh_bindings.glsl for a build)"
#endif
#if !defined(GNO_LIGHT_BVH_ORDER) || !defined(GNO_LIGHT_BVH_BOXES)
#error "rivals/light_bvh_build.glsl: define GNO_LIGHT_BVH_ORDER and GNO_LIGHT_BVH_BOXES (or include light_bvh_bindings.glsl for a build)"
#endif
#if !defined(GNO_LIGHT_BVH_SPLITS) || !defined(GNO_LIGHT_BVH_NODES)
#error "rivals/light_bvh_build.glsl: define GNO_LIGHT_BVH_SPLITS and GNO_LIGHT_BVH_NODES (or include light_bvh_bindings.glsl for a build)"
#endif
#ifndef GNO_LIGHT_BVH_PARENTS
#error "rivals/light_bvh_build.glsl: define GNO_LIGHT_BVH_PARENTS (or include light_bvh_bindings.glsl for a build)"
#endif
#ifndef GNO_LIGHT
#error "rivals/light_bvh_build.glsl: define GNO_LIGHT, a homogeneous vec4"
#endif

#if (GNO_LIGHT_BVH_BUILDS) & (1 | GNO_LIGHT_BVH_PASS_COUNT)
void gnoLightBvhCount(uint caster_, uint faces_, uint group_, uint invocation_) {
    uint total_;
    gnoGroupPrefix(uint(bitCount(faces_)), invocation_, total_);
    if (invocation_ == 0u) GNO_LIGHT_BVH_SUMS[group_] = total_;
    if (invocation_ == 0u && group_ == 0u) {  // until 2 knows better
        GNO_LIGHT_BVH_HEADER.state = 0u;
        GNO_LIGHT_BVH_HEADER.groupsOfReferences = 0u;
        GNO_LIGHT_BVH_HEADER.groupsOfTiles = 0u;
    }
    if (caster_ < uint(GNO_LIGHT_BVH_MASKS.length())) GNO_LIGHT_BVH_MASKS[caster_] = faces_;
}
#endif

#if (GNO_LIGHT_BVH_BUILDS) & (1 | GNO_LIGHT_BVH_PASS_BEGIN)
void gnoLightBvhBegin(uint references_) {
    uint held_ = min(references_, GNO_LIGHT_BVH_CAPACITY);
    GNO_LIGHT_BVH_HEADER.groupsOfReferences = gnoLightBvhGroups(held_);
    GNO_LIGHT_BVH_HEADER.one0 = 1u;
    GNO_LIGHT_BVH_HEADER.one1 = 1u;
    GNO_LIGHT_BVH_HEADER.references = references_;
    GNO_LIGHT_BVH_HEADER.groupsOfTiles = gnoSortTiles(held_);
    GNO_LIGHT_BVH_HEADER.one2 = 1u;
    GNO_LIGHT_BVH_HEADER.one3 = 1u;
    GNO_LIGHT_BVH_HEADER.emitted = 0u;
    GNO_LIGHT_BVH_HEADER.leaves = 0u;
    GNO_LIGHT_BVH_HEADER.state = references_ == 0u ? gnoState(GNO_STATE_ANY) : references_ > held_ ? gnoIncompleteState(GNO_STATE_ANY) : 0u;
    for (uint face_ = 0u; face_ < 6u; ++face_) GNO_LIGHT_BVH_HEADER.roots[face_] = GNO_LIGHT_BVH_NONE;
    for (uint level_ = 0u; level_ < GNO_LIGHT_BVH_LEVELS; ++level_)
        GNO_LIGHT_BVH_LEVEL_TABLE[level_] = GnoLightBvhLevel(level_ == 0u ? 1u : 0u, 1u, 1u, 0u, 0u);
}
#endif

uint gnoLightBvhLength_() { return min(GNO_LIGHT_BVH_HEADER.references, GNO_LIGHT_BVH_CAPACITY); }

#if (GNO_LIGHT_BVH_BUILDS) & (1 | GNO_LIGHT_BVH_PASS_EMIT)
uint gnoLightBvhFirst(uint faces_, uint group_, uint invocation_) {
    uint total_;
    return GNO_LIGHT_BVH_SUMS[group_] + gnoGroupPrefix(uint(bitCount(faces_)), invocation_, total_);
}

void gnoLightBvhEmit(uint caster_, uint faces_, GnoLightBvhCaster c_, uint at_) {
    float least_ = gnoTopLeastDepth(GNO_LIGHT, c_.t);
    if (faces_ != 0u) atomicAdd(GNO_LIGHT_BVH_HEADER.emitted, uint(bitCount(faces_)));
    for (; faces_ != 0u; faces_ &= faces_ - 1u) {
        uint face_ = uint(findLSB(faces_));
        uint low_, high_;
        gnoLightBvhBounds(GNO_LIGHT, GNO_LIGHT_BVH_GRID, face_, c_, low_, high_);
        if (at_ < GNO_LIGHT_BVH_CAPACITY) {
            GNO_LIGHT_BVH_REFERENCES[at_] =
                GnoLightBvhBox(low_, high_, least_, GNO_LIGHT_BVH_LEAF | (c_.facing > 0 ? GNO_LIGHT_BVH_POSITIVE : 0u) | caster_);
            GNO_LIGHT_BVH_KEYS[at_] = gnoLightBvhKey(face_, low_, high_);
            GNO_LIGHT_BVH_ORDER[at_] = at_;
        }
        ++at_;
    }
}
#endif

#if (GNO_LIGHT_BVH_BUILDS) & (1 | GNO_LIGHT_BVH_PASS_LEAVES)
void gnoLightBvhLeaf(uint i_) {
    if (i_ < gnoLightBvhLength_()) GNO_LIGHT_BVH_BOXES[i_] = GNO_LIGHT_BVH_REFERENCES[GNO_LIGHT_BVH_ORDER[i_]];
}
#endif

#if (GNO_LIGHT_BVH_BUILDS) & (1 | GNO_LIGHT_BVH_PASS_UP)
void gnoLightBvhUp(uint row_, uint i_) {
    uint below_ = 0u;  // where the row below begins
    uint boxes_ = gnoLightBvhLength_();
    for (uint r_ = 1u; r_ < row_; ++r_) {
        below_ += boxes_;
        boxes_ = gnoLightBvhNextRow(boxes_);
    }
    uint first_ = GNO_LIGHT_BVH_FAN * i_;
    if (boxes_ < 2u || first_ >= boxes_) return;
    GnoLightBvhBox box_ = GNO_LIGHT_BVH_BOXES[below_ + first_];
    for (uint j_ = first_ + 1u; j_ < min(first_ + GNO_LIGHT_BVH_FAN, boxes_); ++j_) box_ = gnoLightBvhUnion(box_, GNO_LIGHT_BVH_BOXES[below_ + j_]);
    GNO_LIGHT_BVH_BOXES[below_ + boxes_ + i_] = box_;
}
#endif

#if (GNO_LIGHT_BVH_BUILDS) & (1 | GNO_LIGHT_BVH_PASS_SPLIT)
// The union of the sorted references first .. last.
GnoLightBvhBox gnoLightBvhRange_(uint first_, uint last_) {
    uint below_ = 0u;
    uint boxes_ = gnoLightBvhLength_();
    uint end_ = last_ + 1u;
    GnoLightBvhBox box_ = GnoLightBvhBox(0x7FFF7FFFu, 0u, uintBitsToFloat(0x7F7FFFFFu), 0u);
    while (first_ < end_) {
        while (first_ < end_ && first_ % GNO_LIGHT_BVH_FAN != 0u) box_ = gnoLightBvhUnion(box_, GNO_LIGHT_BVH_BOXES[below_ + first_++]);
        while (first_ < end_ && end_ % GNO_LIGHT_BVH_FAN != 0u) box_ = gnoLightBvhUnion(box_, GNO_LIGHT_BVH_BOXES[below_ + --end_]);
        first_ /= GNO_LIGHT_BVH_FAN;
        end_ /= GNO_LIGHT_BVH_FAN;
        below_ += boxes_;
        boxes_ = gnoLightBvhNextRow(boxes_);
    }
    return box_;
}

// Length of the common prefix of two keys, made different by their places; -1 beyond the ends.
int gnoLightBvhPrefix_(uint key_, uint i_, int j_, int count_) {
    if (j_ < 0 || j_ >= count_) return -1;
    uint other_ = GNO_LIGHT_BVH_KEYS[j_];
    return key_ != other_ ? 31 - findMSB(key_ ^ other_) : 63 - findMSB(i_ ^ uint(j_));
}

void gnoLightBvhRoot_(uint face_, uint stands_) {  // stands: what the collapse has to open there
    uint node_ = atomicAdd(GNO_LIGHT_BVH_LEVEL_TABLE[0].count, 1u);
    GNO_LIGHT_BVH_NODES[node_].link.x = stands_;
    GNO_LIGHT_BVH_PARENTS[node_] = GNO_LIGHT_BVH_NONE;
    GNO_LIGHT_BVH_HEADER.roots[face_] = node_;
}

uint gnoLightBvhFaceOf_(uint i_) { return GNO_LIGHT_BVH_KEYS[i_] >> 29; }

// References first .. last are all of a face.
bool gnoLightBvhWhole_(uint first_, uint last_, uint count_) {
    uint face_ = gnoLightBvhFaceOf_(first_);
    return face_ == gnoLightBvhFaceOf_(last_) && (first_ == 0u || gnoLightBvhFaceOf_(first_ - 1u) != face_) &&
           (last_ + 1u == count_ || gnoLightBvhFaceOf_(last_ + 1u) != face_);
}

void gnoLightBvhSplit(uint i_) {
    uint count_ = gnoLightBvhLength_();
    if (i_ >= count_ || GNO_LIGHT_BVH_HEADER.emitted != count_) return;  // none may be missing
    if (gnoLightBvhWhole_(i_, i_, count_)) gnoLightBvhRoot_(gnoLightBvhFaceOf_(i_), GNO_LIGHT_BVH_LEAF | i_);
    if (i_ + 1u == count_) return;
    int n_ = int(count_);
    int at_ = int(i_);
    uint key_ = GNO_LIGHT_BVH_KEYS[i_];
    int before_ = gnoLightBvhPrefix_(key_, i_, at_ - 1, n_);
    int after_ = gnoLightBvhPrefix_(key_, i_, at_ + 1, n_);
    int way_ = after_ > before_ ? 1 : -1;
    int outside_ = min(after_, before_);
    int step_ = 2;
    while (gnoLightBvhPrefix_(key_, i_, at_ + step_ * way_, n_) > outside_) step_ *= 2;
    int length_ = 0;
    for (step_ /= 2; step_ > 0; step_ /= 2) {
        if (gnoLightBvhPrefix_(key_, i_, at_ + (length_ + step_) * way_, n_) > outside_) length_ += step_;
    }
    int inside_ = gnoLightBvhPrefix_(key_, i_, at_ + length_ * way_, n_);
    int reach_ = 0;
    for (step_ = length_; step_ > 1;) {
        step_ = (step_ + 1) / 2;
        if (gnoLightBvhPrefix_(key_, i_, at_ + (reach_ + step_) * way_, n_) > inside_) reach_ += step_;
    }
    uint first_ = uint(min(at_, at_ + length_ * way_));
    uint last_ = uint(max(at_, at_ + length_ * way_));
    uint split_ = uint(at_ + reach_ * way_ + min(way_, 0));
    GnoLightBvhBox box_ = gnoLightBvhRange_(first_, last_);
    box_.link = split_ | (split_ == first_ ? GNO_LIGHT_BVH_FIRST_IS_LEAF : 0u) | (split_ + 1u == last_ ? GNO_LIGHT_BVH_SECOND_IS_LEAF : 0u);
    GNO_LIGHT_BVH_SPLITS[i_] = box_;
    if (gnoLightBvhWhole_(first_, last_, count_)) gnoLightBvhRoot_(gnoLightBvhFaceOf_(first_), i_);
}
#endif

#if (GNO_LIGHT_BVH_BUILDS) & (1 | GNO_LIGHT_BVH_PASS_COLLAPSE)
// `stands`: an inner node of the binary hierarchy, or GNO_LIGHT_BVH_LEAF and a sorted reference.
GnoLightBvhBox gnoLightBvhBoxOf_(uint stands_) {
    if ((stands_ & GNO_LIGHT_BVH_LEAF) != 0u) return GNO_LIGHT_BVH_BOXES[stands_ & ~GNO_LIGHT_BVH_LEAF];
    return GNO_LIGHT_BVH_SPLITS[stands_];
}

void gnoLightBvhCollapse(uint level_, uint i_) {
    uint count_ = GNO_LIGHT_BVH_LEVEL_TABLE[level_].count;
    uint first_ = GNO_LIGHT_BVH_LEVEL_TABLE[level_].first;
    if (i_ == 0u && level_ + 1u < GNO_LIGHT_BVH_LEVELS) GNO_LIGHT_BVH_LEVEL_TABLE[level_ + 1u].first = first_ + count_;
    if (i_ >= count_) return;
    uint node_ = first_ + i_;
    uint stands_[4];
    GnoLightBvhBox boxes_[4];
    stands_[0] = GNO_LIGHT_BVH_NODES[node_].link.x;
    boxes_[0] = gnoLightBvhBoxOf_(stands_[0]);
    uint children_ = 1u;
    while (children_ < 4u) {  // open the largest inner one
        uint widest_ = 4u;
        float area_ = 0.0f;
        for (uint c_ = 0u; c_ < children_; ++c_) {
            float its_ = gnoLightBvhArea(boxes_[c_].low, boxes_[c_].high);
            if ((stands_[c_] & GNO_LIGHT_BVH_LEAF) == 0u && its_ > area_) {
                widest_ = c_;
                area_ = its_;
            }
        }
        if (widest_ == 4u) break;
        uint split_ = boxes_[widest_].link;
        uint at_ = split_ & GNO_LIGHT_BVH_CASTER;
        stands_[widest_] = (split_ & GNO_LIGHT_BVH_FIRST_IS_LEAF) != 0u ? GNO_LIGHT_BVH_LEAF | at_ : at_;
        stands_[children_] = (split_ & GNO_LIGHT_BVH_SECOND_IS_LEAF) != 0u ? GNO_LIGHT_BVH_LEAF | (at_ + 1u) : at_ + 1u;
        boxes_[widest_] = gnoLightBvhBoxOf_(stands_[widest_]);
        boxes_[children_] = gnoLightBvhBoxOf_(stands_[children_]);
        ++children_;
    }
    uint inner_ = 0u;
    for (uint c_ = 0u; c_ < children_; ++c_) inner_ += (stands_[c_] & GNO_LIGHT_BVH_LEAF) == 0u ? 1u : 0u;
    if (inner_ < children_) {
        uint before_ = atomicAdd(GNO_LIGHT_BVH_HEADER.leaves, children_ - inner_);
        if (before_ + children_ - inner_ == GNO_LIGHT_BVH_HEADER.references) GNO_LIGHT_BVH_HEADER.state = gnoState(GNO_STATE_ANY);
    }
    uint next_ = 0u;
    if (inner_ > 0u) {
        uint taken_ = atomicAdd(GNO_LIGHT_BVH_LEVEL_TABLE[level_ + 1u].count, inner_);
        atomicMax(GNO_LIGHT_BVH_LEVEL_TABLE[level_ + 1u].groups, gnoLightBvhGroups(taken_ + inner_));
        next_ = first_ + count_ + taken_;
    }
    GnoLightBvhNode made_ = GnoLightBvhNode(uvec4(0x7FFF7FFFu), uvec4(0u), vec4(0.0f), uvec4(GNO_LIGHT_BVH_NONE));
    for (uint c_ = 0u; c_ < children_; ++c_) {
        made_.low[c_] = boxes_[c_].low;
        made_.high[c_] = boxes_[c_].high;
        made_.least[c_] = boxes_[c_].least;
        made_.link[c_] = boxes_[c_].link;
        if ((stands_[c_] & GNO_LIGHT_BVH_LEAF) != 0u) continue;
        made_.link[c_] = next_;
        GNO_LIGHT_BVH_NODES[next_].link.x = stands_[c_];
        GNO_LIGHT_BVH_PARENTS[next_] = (node_ << 2) | c_;
        ++next_;
    }
    GNO_LIGHT_BVH_NODES[node_] = made_;
}
#endif
#endif
