// SPDX-License-Identifier: MIT
// gnomon rivals/light_grid_build.glsl : from pairs of cell and caster (forest/assign.glsl) to lists of casters; cells with many casters get sub
// cells.
//
//   void gnoLightGridReset()                                                      1: one invocation, before open
//   void gnoLightGridOpen(uint cell)                                              2: instead of gnoForestAllocate, which it calls; one invocation
//   per cell
//   void gnoLightGridSizes()                                                      3: group counts for the passes over pairs and lists; one
//   invocation
//   void gnoLightGridSeeSample(vec3 p)                                            4: sub cells know how far their view samples lie; one invocation
//   per sample
//   void gnoLightGridCount(uint cell, GnoCaster t, int facing)                    5: how many casters each sub cell keeps; one invocation per pair,
//   as 7
//   void gnoLightGridAllocate(uint list)                                          6: where its items go; one invocation per list
//   void gnoLightGridEmit(uint cell, uint caster, GnoCaster t, int facing)        7: puts them there, in any order: light_grid_sort.glsl comes next
//   void gnoLightGridFinish()                                                     8: one invocation of each work group that has sorted 64 lists;
//                                                                                 the last one tells the queries that the lists may be asked
//   void gnoLightGridFinishPlanes()                                               one invocation of the pass that writes planes, where there are any
//
// Each step is a dispatch of its own. gnoForestEmit comes between 3 and 5; its pairs are not needed after 7. A caster is kept in a sub cell unless
// its volume certainly misses it, or begins beyond its farthest view sample (with GNO_FOREST_VIEW_CULL; without it 4 has no use). What hides a whole
// sub cell is not looked for: it would leave out 1 % of the items and shortens no walk, because the list is in order. 5 and 7 see the same sub
// cells, so a pool of header.items items is filled exactly; in a smaller one the rest is left out and header.items tells: the lists are not complete
// then, and a query over them answers GNO_VISIBILITY_UNKNOWN. A cell that finds no room for its sub cells stays one list: longer, and right.
//
// Space      light coordinates; samples on the scene grid; facing = gnoFacing(light, t), never 0
// Stages     any with storage buffers; may diverge
// Requires   #version 450, no extension
// Reads      grid, cells
// Writes     cells, lists, depths, items, header, by atomics (2, 4, 5, 6, 7) or alone
// Cost       5, 7: at most 64 sub cells per pair, 3 plane evaluations each
//
// Macro                     required  default  meaning
// GNO_LIGHT_GRID_BUILDS     no        1        which steps this shader has: 1 GNO_LIGHT_GRID_PASS_RESET, 2 .._OPEN, 3 .._SIZES, 4 .._DEPTH,
//                                              5 .._COUNT, 6 .._ALLOCATE, 7 .._EMIT, 8 .._SORT, .._PLANES; several with |, 1 for all;
//                                              light_grid_bindings.glsl makes writable what they write
// GNO_LIGHT_GRID_LISTS      yes       -        array of GnoLightGridList in a storage buffer
// GNO_LIGHT_GRID_DEPTHS     yes       -        array of uint in a storage buffer
// GNO_LIGHT_GRID_NESTS      yes       -        cells for whose sub cells lists and depths have room
// GNO_LIGHT_GRID_ITEMS      yes       -        array of GnoLightGridItem in a storage buffer
// GNO_LIGHT_GRID_CAPACITY   yes       -        items that the pool holds
// GNO_LIGHT_GRID_HEADER     yes       -        GnoLightGridHeader in a storage buffer
// GNO_LIGHT_GRID_NEST       no        8u       a cell with more casters gets sub cells; 0: none does
// The macros of ../forest/assign.glsl
#ifndef GNO_RIVALS_LIGHT_GRID_BUILD_GLSL
#define GNO_RIVALS_LIGHT_GRID_BUILD_GLSL
#ifndef GNO_LIGHT_GRID_BUILDS
#define GNO_LIGHT_GRID_BUILDS 1
#endif
#include "light_grid_place.glsl"
#if (GNO_LIGHT_GRID_BUILDS) == 0
#error "rivals/light_grid_build.glsl: which pass is this? define GNO_LIGHT_GRID_BUILDS before light_grid_bindings.glsl, as light_grid.h says"
#endif
#if (GNO_LIGHT_GRID_BUILDS) & (1 | GNO_LIGHT_GRID_PASS_OPEN)
#include "../forest/assign.glsl"  // gnoForestAllocate
#endif
#ifndef GNO_FOREST_VIEW_CULL
#define GNO_FOREST_VIEW_CULL 1
#endif
#if !defined(GNO_LIGHT_GRID_LISTS) || !defined(GNO_LIGHT_GRID_DEPTHS)
#error "rivals/light_grid_build.glsl: define GNO_LIGHT_GRID_LISTS and GNO_LIGHT_GRID_DEPTHS (or include light_grid_bindings.glsl)"
#endif
#if !defined(GNO_LIGHT_GRID_NESTS) || !defined(GNO_LIGHT_GRID_ITEMS)
#error "rivals/light_grid_build.glsl: define GNO_LIGHT_GRID_NESTS and GNO_LIGHT_GRID_ITEMS (or include light_grid_bindings.glsl)"
#endif
#if !defined(GNO_LIGHT_GRID_CAPACITY) || !defined(GNO_LIGHT_GRID_HEADER)
#error "rivals/light_grid_build.glsl: define GNO_LIGHT_GRID_CAPACITY and GNO_LIGHT_GRID_HEADER (or include light_grid_bindings.glsl)"
#endif
#ifndef GNO_LIGHT_GRID_NEST
#define GNO_LIGHT_GRID_NEST 8u
#endif
GNO_NAMESPACE_BEGIN

#if (GNO_LIGHT_GRID_BUILDS) & (1 | GNO_LIGHT_GRID_PASS_RESET)
GNO_INLINE void gnoLightGridReset() {
    uint planes_ = GNO_LIGHT_GRID_HEADER.planes;  // they outlive the lists
    GNO_LIGHT_GRID_HEADER = GnoLightGridHeader(0u, 1u, 1u, 0u, 0u, 1u, 1u, 0u, 0u, 0u, 0u, 0u, planes_);
}
#endif

GNO_INLINE uint gnoLightGridFirstSub_() { return gnoLightGridFirstSub(gnoCellCount(GNO_FOREST_GRID.resolution, GNO_FOREST_GRID.faces)); }

#if (GNO_LIGHT_GRID_BUILDS) & (1 | GNO_LIGHT_GRID_PASS_OPEN)
GNO_INLINE void gnoLightGridOpen(uint cell_) {
    if (cell_ >= gnoCellCount(GNO_FOREST_GRID.resolution, GNO_FOREST_GRID.faces)) {
        if (cell_ < gnoLightGridFirstSub_()) GNO_LIGHT_GRID_LISTS[cell_] = GnoLightGridList(0u, 0u);
        return;
    }
    uint count_ = GNO_FOREST_CELLS[cell_].pairs;
    gnoForestAllocate(cell_);
    GNO_LIGHT_GRID_LISTS[cell_] = GnoLightGridList(0u, count_);
    if (GNO_LIGHT_GRID_NEST == 0u || count_ <= GNO_LIGHT_GRID_NEST) return;
    uint nest_ = atomicAdd(GNO_LIGHT_GRID_HEADER.nests, 1u);
    if (nest_ >= GNO_LIGHT_GRID_NESTS) return;
    uint first_ = gnoLightGridFirstSub_() + GNO_LIGHT_GRID_GROUP * nest_;
    GNO_LIGHT_GRID_LISTS[cell_] = GnoLightGridList(first_, GNO_LIGHT_GRID_NESTED);
    for (uint i_ = 0u; i_ < GNO_LIGHT_GRID_GROUP; ++i_) {
        GNO_LIGHT_GRID_LISTS[first_ + i_] = GnoLightGridList(0u, 0u);
        GNO_LIGHT_GRID_DEPTHS[GNO_LIGHT_GRID_GROUP * nest_ + i_] = 0u;
    }
}
#endif

#if (GNO_LIGHT_GRID_BUILDS) & (1 | GNO_LIGHT_GRID_PASS_SIZES)
GNO_INLINE void gnoLightGridSizes() {
    uint pairs_ = GNO_FOREST_HEADER.state == gnoState(GNO_STATE_ANY) ? min(GNO_FOREST_HEADER.pairs, GNO_FOREST_CAPACITY) : 0u;
    uint groups_ = gnoLightGridFirstSub_() / GNO_LIGHT_GRID_GROUP + min(GNO_LIGHT_GRID_HEADER.nests, GNO_LIGHT_GRID_NESTS);
    GNO_LIGHT_GRID_HEADER.groupsOfPairs = min((pairs_ + GNO_LIGHT_GRID_GROUP - 1u) / GNO_LIGHT_GRID_GROUP, 65535u);
    GNO_LIGHT_GRID_HEADER.groupsOfLists = min(groups_, 65535u);
    GNO_LIGHT_GRID_HEADER.groups = groups_;
}
#endif

#if (GNO_LIGHT_GRID_BUILDS) & (1 | GNO_LIGHT_GRID_PASS_DEPTH)
GNO_INLINE void gnoLightGridSeeSample(vec3 p_) {
    vec3 q_ = gnoFromLight(GNO_LIGHT, p_);
    uvec2 place_ = gnoLightGridPlace(GNO_LIGHT, GNO_FOREST_GRID, q_);
    GnoLightGridList list_ = GNO_LIGHT_GRID_LISTS[place_.x];
    if (list_.end != GNO_LIGHT_GRID_NESTED) return;
    uint depth_ = floatBitsToUint(gnoLightDepth(GNO_LIGHT, q_)) + 1u;
    atomicMax(GNO_LIGHT_GRID_DEPTHS[list_.first - gnoLightGridFirstSub_() + place_.y], depth_);
}
#endif

#if (GNO_LIGHT_GRID_BUILDS) & (1 | GNO_LIGHT_GRID_PASS_COUNT | GNO_LIGHT_GRID_PASS_EMIT)
struct GnoLightGridSpan_ {  // the sub cells of one cell that a caster's volume may meet
    uint first;             // list of the cell's sub cell 0
    uint face;
    uvec2 corner;           // fine column and row of the cell's sub cell 0
    uvec2 from;             // fine columns and rows from .. to - 1
    uvec2 to;
    bool all;               // none needs a look: a rectangle of one column or row has none that is certainly missed
};

GNO_INLINE GnoLightGridSpan_ gnoLightGridSpan_(uint cell_, uint first_, GnoForestGrid fine_, GnoCellVolume v_) {
    GnoLightGridSpan_ span_;
    uvec3 at_ = gnoLightGridAt(GNO_FOREST_GRID, cell_);
    uvec4 r_ = gnoCellRectangle(GNO_LIGHT, fine_, at_.z, v_);
    span_.first = first_;
    span_.face = at_.z;
    span_.all = min(r_.z - r_.x, r_.w - r_.y) == 1u;
    span_.corner = uvec2(8u * at_.x, 8u * at_.y);
    span_.from = max(uvec2(r_.x, r_.y), span_.corner);
    span_.to = min(uvec2(r_.z, r_.w), span_.corner + uvec2(8u, 8u));
    return span_;
}

GNO_INLINE uint gnoLightGridSub_(GnoLightGridSpan_ span_, uvec2 at_) {
    return span_.first + 8u * (at_.y - span_.corner.y) + (at_.x - span_.corner.x);
}

GNO_INLINE bool gnoLightGridKeeps_(GnoForestGrid fine_, GnoLightGridSpan_ span_, uvec2 at_, GnoCellVolume v_) {
    uint farthest_ = GNO_LIGHT_GRID_DEPTHS[gnoLightGridSub_(span_, at_) - gnoLightGridFirstSub_()];
    if (GNO_FOREST_VIEW_CULL != 0 && farthest_ <= floatBitsToUint(v_.least)) return false;
    return span_.all || !gnoCellMissed(GNO_LIGHT, fine_, span_.face, at_, v_);
}
#endif

#if (GNO_LIGHT_GRID_BUILDS) & (1 | GNO_LIGHT_GRID_PASS_COUNT)
GNO_INLINE void gnoLightGridCount(uint cell_, GnoCaster t_, int facing_) {
    GnoLightGridList list_ = GNO_LIGHT_GRID_LISTS[cell_];
    if (list_.end != GNO_LIGHT_GRID_NESTED) return;
    GnoCellVolume v_ = gnoCellVolume(GNO_LIGHT, t_, facing_);
    GnoForestGrid fine_ = gnoLightGridFine(GNO_FOREST_GRID);
    GnoLightGridSpan_ span_ = gnoLightGridSpan_(cell_, list_.first, fine_, v_);
    for (uint y_ = span_.from.y; y_ < span_.to.y; ++y_) {
        for (uint x_ = span_.from.x; x_ < span_.to.x; ++x_) {
            uvec2 at_ = uvec2(x_, y_);
            if (gnoLightGridKeeps_(fine_, span_, at_, v_)) atomicAdd(GNO_LIGHT_GRID_LISTS[gnoLightGridSub_(span_, at_)].end, 1u);
        }
    }
}
#endif

#if (GNO_LIGHT_GRID_BUILDS) & (1 | GNO_LIGHT_GRID_PASS_ALLOCATE)
GNO_INLINE void gnoLightGridAllocate(uint list_) {
    uint count_ = GNO_LIGHT_GRID_LISTS[list_].end;
    if (count_ == GNO_LIGHT_GRID_NESTED) return;
    uint first_ = count_ == 0u ? 0u : atomicAdd(GNO_LIGHT_GRID_HEADER.items, count_);
    GNO_LIGHT_GRID_LISTS[list_] = GnoLightGridList(first_, first_);
}
#endif

#if (GNO_LIGHT_GRID_BUILDS) & (1 | GNO_LIGHT_GRID_PASS_EMIT)
GNO_INLINE void gnoLightGridPut_(uint list_, GnoLightGridItem item_) {
    uint slot_ = atomicAdd(GNO_LIGHT_GRID_LISTS[list_].end, 1u);
    if (slot_ < GNO_LIGHT_GRID_CAPACITY) GNO_LIGHT_GRID_ITEMS[slot_] = item_;
}

GNO_INLINE void gnoLightGridEmit(uint cell_, uint caster_, GnoCaster t_, int facing_) {
    uint named_ = facing_ > 0 ? caster_ | GNO_LIGHT_GRID_FRONT : caster_;
    GnoLightGridList list_ = GNO_LIGHT_GRID_LISTS[cell_];
    if (list_.end != GNO_LIGHT_GRID_NESTED) {
        gnoLightGridPut_(cell_, GnoLightGridItem(floatBitsToUint(gnoTopLeastDepth(GNO_LIGHT, t_)), named_));
        atomicAdd(GNO_LIGHT_GRID_HEADER.emitted, 1u);
        return;
    }
    GnoCellVolume v_ = gnoCellVolume(GNO_LIGHT, t_, facing_);
    GnoForestGrid fine_ = gnoLightGridFine(GNO_FOREST_GRID);
    GnoLightGridSpan_ span_ = gnoLightGridSpan_(cell_, list_.first, fine_, v_);
    GnoLightGridItem item_ = GnoLightGridItem(floatBitsToUint(v_.least), named_);
    uint put_ = 0u;
    for (uint y_ = span_.from.y; y_ < span_.to.y; ++y_) {
        for (uint x_ = span_.from.x; x_ < span_.to.x; ++x_) {
            uvec2 at_ = uvec2(x_, y_);
            if (!gnoLightGridKeeps_(fine_, span_, at_, v_)) continue;
            gnoLightGridPut_(gnoLightGridSub_(span_, at_), item_);
            ++put_;
        }
    }
    if (put_ > 0u) atomicAdd(GNO_LIGHT_GRID_HEADER.emitted, put_);
}
#endif

#if (GNO_LIGHT_GRID_BUILDS) & (1 | GNO_LIGHT_GRID_PASS_SORT)
// Nothing before it is written again: what is read here lies still.
GNO_INLINE void gnoLightGridFinish() {
    if (atomicAdd(GNO_LIGHT_GRID_HEADER.finished, 1u) + 1u != GNO_LIGHT_GRID_HEADER.groups) return;
    uint pairs_ = gnoForestState(GNO_FOREST_HEADER, GNO_FOREST_CAPACITY, GNO_STATE_ANY);
    bool put_ = GNO_LIGHT_GRID_HEADER.emitted == GNO_LIGHT_GRID_HEADER.items;
    bool held_ = GNO_LIGHT_GRID_HEADER.items <= GNO_LIGHT_GRID_CAPACITY;
    GNO_LIGHT_GRID_HEADER.state = !put_ ? 0u : held_ ? pairs_ : gnoIncompleteState(GNO_STATE_ANY);
}
#endif

#if (GNO_LIGHT_GRID_BUILDS) & (1 | GNO_LIGHT_GRID_PASS_PLANES)
GNO_INLINE void gnoLightGridFinishPlanes() { GNO_LIGHT_GRID_HEADER.planes = gnoState(GNO_STATE_ANY); }
#endif

GNO_NAMESPACE_END
#endif
