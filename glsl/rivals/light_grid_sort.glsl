// SPDX-License-Identifier: MIT
// gnomon rivals/light_grid_sort.glsl : brings the items of 64 lists into order: by least depth, and by caster where that is equal.
//
//   void gnoLightGridSort(uint group, uint lane)      lists 64 group .. 64 group + 63; all 64 invocations of a work group call it, lane 0 .. 63
//
// A short list is sorted by one invocation, by insertion with shrinking gaps; a longer one by the whole work group: blocks of 512 items in shared
// memory (runs of eight by insertion, then merges in which each item finds its place in the other run by bisection), and above that in place by
// Batcher's bitonic merges, in the form in which every comparison puts the smaller item first, so that a list whose length is no power of two needs
// nothing at its end (comparisons with what is not there are left out). A caster is once in a list, so the order is total and the lists do not
// depend on the order in which their items came.
//
// Space      none: no positions
// Stages     compute, work groups of 64; it holds barriers: all invocations of the work group call it
// Requires   #version 450, no extension
// Reads      lists; writes items. What one invocation writes another one of the group reads after memoryBarrierBuffer() and barrier(); the items
//            must be `coherent`
// Cost       n items: up to GNO_LIGHT_GRID_SHORT, fewer than n^2 / 4 steps of one invocation; up to 512, n (log2 n)^2 / 128 of each of the group's;
//            above, (log2(n / 512))^2 n / 256
//            more; 8 KiB of shared memory
//
// Macro                     required  default  meaning
// GNO_LIGHT_GRID_BUILDS     no        1        GNO_LIGHT_GRID_PASS_SORT, alone or with | among others, or 1
// GNO_LIGHT_GRID_LISTS      yes       -        array of GnoLightGridList
// GNO_LIGHT_GRID_ITEMS      yes       -        array of GnoLightGridItem in a coherent storage buffer
// GNO_LIGHT_GRID_CAPACITY   yes       -        items that the pool holds; a list that reaches beyond is left as it is
// GNO_LIGHT_GRID_SHORT      no        32u      items that one invocation sorts
#ifndef GNO_RIVALS_LIGHT_GRID_SORT_GLSL
#define GNO_RIVALS_LIGHT_GRID_SORT_GLSL
#include "light_grid.h"
#ifndef GNO_LIGHT_GRID_BUILDS
#define GNO_LIGHT_GRID_BUILDS 1
#endif
#if !((GNO_LIGHT_GRID_BUILDS) & (1 | GNO_LIGHT_GRID_PASS_SORT))
#error "rivals/light_grid_sort.glsl: which pass is this? define GNO_LIGHT_GRID_BUILDS before light_grid_bindings.glsl, as light_grid.h says"
#endif
#if !defined(GNO_LIGHT_GRID_LISTS) || !defined(GNO_LIGHT_GRID_ITEMS)
#error "rivals/light_grid_sort.glsl: define GNO_LIGHT_GRID_LISTS and GNO_LIGHT_GRID_ITEMS (or include light_grid_bindings.glsl)"
#endif
#ifndef GNO_LIGHT_GRID_CAPACITY
#error "rivals/light_grid_sort.glsl: define GNO_LIGHT_GRID_CAPACITY (or include light_grid_bindings.glsl)"
#endif
#ifndef GNO_LIGHT_GRID_SHORT
#define GNO_LIGHT_GRID_SHORT 32u
#endif

const uint GNO_LIGHT_GRID_BLOCK_ = 512u;
shared uint gnoLightGridLong_[2];  // a bit per list
const uint GNO_LIGHT_GRID_RUN_ = 8u;
shared uint gnoLightGridDepths_[2u * GNO_LIGHT_GRID_BLOCK_];  // two halves: merges read one and write the other
shared uint gnoLightGridCasters_[2u * GNO_LIGHT_GRID_BLOCK_];

bool gnoLightGridBefore_(GnoLightGridItem a_, GnoLightGridItem b_) { return a_.depth != b_.depth ? a_.depth < b_.depth : a_.caster < b_.caster; }

// Insertion sort of every gap-th item, for gaps 23, 10, 4 and 1 (Ciura, Best Increments for the Average Case of Shellsort, FCT 2001).
void gnoLightGridSortAlone_(uint first_, uint end_) {
    for (uint gap_ = 23u; gap_ > 0u; gap_ = gap_ == 23u ? 10u : gap_ == 10u ? 4u : gap_ / 4u) {
        for (uint i_ = first_ + gap_; i_ < end_; ++i_) {
            GnoLightGridItem item_ = GNO_LIGHT_GRID_ITEMS[i_];
            uint at_ = i_;
            while (at_ >= first_ + gap_) {
                GnoLightGridItem other_ = GNO_LIGHT_GRID_ITEMS[at_ - gap_];
                if (!gnoLightGridBefore_(item_, other_)) break;
                GNO_LIGHT_GRID_ITEMS[at_] = other_;
                at_ -= gap_;
            }
            GNO_LIGHT_GRID_ITEMS[at_] = item_;
        }
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

bool gnoLightGridSharedBefore_(uint at_, GnoLightGridItem item_) {
    uint depth_ = gnoLightGridDepths_[at_];
    return depth_ < item_.depth || (depth_ == item_.depth && gnoLightGridCasters_[at_] < item_.caster);
}

void gnoLightGridSetShared_(uint at_, GnoLightGridItem item_) {
    gnoLightGridDepths_[at_] = item_.depth;
    gnoLightGridCasters_[at_] = item_.caster;
}

GnoLightGridItem gnoLightGridShared_(uint at_) { return GnoLightGridItem(gnoLightGridDepths_[at_], gnoLightGridCasters_[at_]); }

void gnoLightGridSortRun_(uint first_, uint end_) {
    for (uint i_ = first_ + 1u; i_ < end_; ++i_) {
        GnoLightGridItem item_ = gnoLightGridShared_(i_);
        uint at_ = i_;
        while (at_ > first_ && !gnoLightGridSharedBefore_(at_ - 1u, item_)) {
            gnoLightGridSetShared_(at_, gnoLightGridShared_(at_ - 1u));
            --at_;
        }
        gnoLightGridSetShared_(at_, item_);
    }
}

// Runs of `width_` items from `from_` on become runs of twice that at `to_`.
void gnoLightGridMerge_(uint count_, uint width_, uint from_, uint to_, uint lane_) {
    for (uint n_ = lane_; n_ < count_; n_ += GNO_LIGHT_GRID_GROUP) {
        GnoLightGridItem item_ = gnoLightGridShared_(from_ + n_);
        uint within_ = n_ & (width_ - 1u);
        uint base_ = n_ & ~(2u * width_ - 1u);
        uint other_ = n_ - within_ == base_ ? base_ + width_ : base_;
        uint low_ = min(other_, count_);
        uint high_ = min(other_ + width_, count_);
        other_ = low_;
        while (low_ < high_) {
            uint middle_ = (low_ + high_) >> 1;
            if (gnoLightGridSharedBefore_(from_ + middle_, item_)) low_ = middle_ + 1u;
            else high_ = middle_;
        }
        gnoLightGridSetShared_(to_ + base_ + within_ + (low_ - other_), item_);
    }
    barrier();
}

void gnoLightGridSortBlock_(uint first_, uint count_, uint lane_) {
    for (uint n_ = lane_; n_ < count_; n_ += GNO_LIGHT_GRID_GROUP) gnoLightGridSetShared_(n_, GNO_LIGHT_GRID_ITEMS[first_ + n_]);
    barrier();
    uint run_ = GNO_LIGHT_GRID_RUN_ * lane_;
    if (run_ < count_) gnoLightGridSortRun_(run_, min(run_ + GNO_LIGHT_GRID_RUN_, count_));
    barrier();
    uint from_ = 0u;
    for (uint width_ = GNO_LIGHT_GRID_RUN_; width_ < count_; width_ *= 2u) {
        gnoLightGridMerge_(count_, width_, from_, GNO_LIGHT_GRID_BLOCK_ - from_, lane_);
        from_ = GNO_LIGHT_GRID_BLOCK_ - from_;
    }
    for (uint n_ = lane_; n_ < count_; n_ += GNO_LIGHT_GRID_GROUP) GNO_LIGHT_GRID_ITEMS[first_ + n_] = gnoLightGridShared_(from_ + n_);
    memoryBarrierBuffer();
    barrier();
}

void gnoLightGridSortTogether_(uint first_, uint count_, uint lane_) {
    for (uint at_ = 0u; at_ < count_; at_ += GNO_LIGHT_GRID_BLOCK_)
        gnoLightGridSortBlock_(first_ + at_, min(GNO_LIGHT_GRID_BLOCK_, count_ - at_), lane_);
    uint half_ = 1u << findMSB(count_ - 1u);  // 2 half: the power of two that is not below count
    for (uint size_ = GNO_LIGHT_GRID_BLOCK_; size_ <= half_; size_ *= 2u) {
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
