// SPDX-License-Identifier: MIT
// gnomon rivals/light_grid_sort.glsl : brings the items of 64 lists into order: by least depth, and by caster where that is equal.
//
//   void gnoLightGridSort(uint group, uint lane)      lists 64 group .. 64 group + 63; all 64 invocations of a work group call it, lane 0 .. 63
//
// A short list is sorted by one invocation, by insertion. A long one is sorted by the whole work group in place: Batcher's bitonic sorter in the form in which every
// comparison puts the smaller item first, so that a list whose length is no power of two needs nothing at its end (comparisons with what is not there are left out).
// The order is total, so the lists do not depend on the order in which their items came.
//
// Space      none: no positions
// Stages     compute, work groups of 64; it holds barriers: all invocations of the work group call it
// Requires   #version 450, no extension
// Reads      lists; writes items. What one invocation writes another one of the group reads after memoryBarrierBuffer() and barrier(); the items must be `coherent`
// Cost       n items: n^2 / 4 steps of one invocation at most GNO_LIGHT_GRID_SHORT; above n log^2 n / 256 per invocation; 8 bytes of shared memory
//
// Macro                     required  default  meaning
// GNO_LIGHT_GRID_LISTS      yes       -        array of GnoLightGridList
// GNO_LIGHT_GRID_ITEMS      yes       -        array of GnoLightGridItem in a coherent storage buffer
// GNO_LIGHT_GRID_CAPACITY   yes       -        items that the pool holds; a list that reaches beyond is left as it is
// GNO_LIGHT_GRID_SHORT      no        32u      items that one invocation sorts
#ifndef GNO_RIVALS_LIGHT_GRID_SORT_GLSL
#define GNO_RIVALS_LIGHT_GRID_SORT_GLSL
#include "light_grid.h"
#if !defined(GNO_LIGHT_GRID_LISTS) || !defined(GNO_LIGHT_GRID_ITEMS) || !defined(GNO_LIGHT_GRID_CAPACITY)
#error "rivals/light_grid_sort.glsl: define GNO_LIGHT_GRID_LISTS, GNO_LIGHT_GRID_ITEMS and GNO_LIGHT_GRID_CAPACITY or include rivals/light_grid_bindings.glsl before this file"
#endif
#ifndef GNO_LIGHT_GRID_SHORT
#define GNO_LIGHT_GRID_SHORT 32u
#endif

shared uint gnoLightGridLong_[2];  // a bit per list

bool gnoLightGridBefore_(GnoLightGridItem a_, GnoLightGridItem b_) { return a_.depth != b_.depth ? a_.depth < b_.depth : a_.caster < b_.caster; }

void gnoLightGridSortAlone_(uint first_, uint end_) {
    for (uint i_ = first_ + 1u; i_ < end_; ++i_) {
        GnoLightGridItem item_ = GNO_LIGHT_GRID_ITEMS[i_];
        uint at_ = i_;
        while (at_ > first_) {
            GnoLightGridItem other_ = GNO_LIGHT_GRID_ITEMS[at_ - 1u];
            if (!gnoLightGridBefore_(item_, other_)) break;
            GNO_LIGHT_GRID_ITEMS[at_] = other_;
            --at_;
        }
        GNO_LIGHT_GRID_ITEMS[at_] = item_;
    }
}

// One round: invocations share the pairs of a list of `half_` pairs and more; `low` and the partner `apart` away, or mirrored within 2 apart.
void gnoLightGridRound_(uint first_, uint count_, uint half_, uint apart_, bool mirrored_, uint lane_) {
    for (uint n_ = lane_; n_ < half_; n_ += GNO_LIGHT_GRID_GROUP) {
        uint within_ = n_ & (apart_ - 1u);
        uint base_ = 2u * (n_ - within_);
        uint low_ = base_ + within_;
        uint high_ = mirrored_ ? base_ + 2u * apart_ - 1u - within_ : low_ + apart_;
        if (high_ >= count_) continue;
        GnoLightGridItem a_ = GNO_LIGHT_GRID_ITEMS[first_ + low_];
        GnoLightGridItem b_ = GNO_LIGHT_GRID_ITEMS[first_ + high_];
        if (gnoLightGridBefore_(b_, a_)) {
            GNO_LIGHT_GRID_ITEMS[first_ + low_] = b_;
            GNO_LIGHT_GRID_ITEMS[first_ + high_] = a_;
        }
    }
    memoryBarrierBuffer();
    barrier();
}

void gnoLightGridSortTogether_(uint first_, uint count_, uint lane_) {
    uint half_ = 1u << findMSB(count_ - 1u);  // 2 half: the power of two that is not below count
    for (uint size_ = 1u; size_ <= half_; size_ *= 2u) {
        gnoLightGridRound_(first_, count_, half_, size_, true, lane_);
        for (uint apart_ = size_ / 2u; apart_ > 0u; apart_ /= 2u) gnoLightGridRound_(first_, count_, half_, apart_, false, lane_);
    }
}

void gnoLightGridSort(uint group_, uint lane_) {
    if (lane_ < 2u) gnoLightGridLong_[lane_] = 0u;
    barrier();
    GnoLightGridList own_ = GNO_LIGHT_GRID_LISTS[GNO_LIGHT_GRID_GROUP * group_ + lane_];
    bool sortable_ = own_.end != GNO_LIGHT_GRID_NESTED && own_.end <= GNO_LIGHT_GRID_CAPACITY;
    if (sortable_ && own_.end - own_.first > GNO_LIGHT_GRID_SHORT) atomicOr(gnoLightGridLong_[lane_ >> 5], 1u << (lane_ & 31u));
    else if (sortable_) gnoLightGridSortAlone_(own_.first, own_.end);
    barrier();
    for (uint word_ = 0u; word_ < 2u; ++word_) {
        for (uint rest_ = gnoLightGridLong_[word_]; rest_ != 0u; rest_ &= rest_ - 1u) {
            GnoLightGridList list_ = GNO_LIGHT_GRID_LISTS[GNO_LIGHT_GRID_GROUP * group_ + 32u * word_ + uint(findLSB(rest_))];
            gnoLightGridSortTogether_(list_.first, list_.end - list_.first, lane_);
        }
    }
    barrier();
}
#endif
