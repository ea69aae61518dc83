// SPDX-License-Identifier: MIT
// gnomon core/radix_sort.glsl : sorts pairs of key and value by the key, stable, 4 bits a round.
//
//   void gnoSortCount(uint tile, uint invocation)        dispatch 1 of a round: how often each digit occurs in a tile
//   (gnoArrayPrefix of core/prefix_sum.glsl over the counts, gnoSortCounts(length) of them: dispatch 2, one work group)
//   void gnoSortScatter(uint tile, uint invocation)      dispatch 3: every pair goes to its place
//
// A tile is GNO_SORT_TILE pairs and belongs to one work group; each invocation takes GNO_SORT_SHARE pairs in a row and has counters of its own in
// shared memory, so there is no atomic, and equal keys keep their order. A round reads keys and values and writes the sorted ones, which must be
// other arrays; eight rounds (shift 0, 4 .. 28) sort whole words and end where they began. Work groups wait for each other only at the ends of
// dispatches.
//
// Space      none: no positions
// Stages     compute; holds barriers: all GNO_SORT_GROUP invocations of the work group call, in uniform control flow
// Requires   #version 450, no extension, any subgroup width
// Writes     counts (1), sorted keys and values (3)
// Cost       each pair is read twice and written once per round; 4 KiB + 256 bytes of shared memory, 3 barriers
//
// Macro                     required  default  meaning
// GNO_SORT_RUNS             no        1        which functions this shader has: GNO_SORT_PASS_COUNT, GNO_SORT_PASS_SCATTER, or 1 for both; what the
//                                              other one writes may be read-only or absent
// GNO_SORT_LENGTH           yes       -        pairs
// GNO_SORT_SHIFT            yes       -        lowest bit of this round's digit
// GNO_SORT_KEYS             yes       -        array of uint
// GNO_SORT_VALUES           yes       -        array of uint; for scattering
// GNO_SORT_SORTED_KEYS      yes       -        array of uint in a storage buffer; for scattering
// GNO_SORT_SORTED_VALUES    yes       -        array of uint in a storage buffer; for scattering
// GNO_SORT_COUNTS           yes       -        array of uint in a storage buffer, gnoSortCounts(GNO_SORT_LENGTH)
#ifndef GNO_CORE_RADIX_SORT_GLSL
#define GNO_CORE_RADIX_SORT_GLSL
#include "radix_sort.h"
#ifndef GNO_SORT_RUNS
#define GNO_SORT_RUNS 1
#endif
#if !defined(GNO_SORT_LENGTH) || !defined(GNO_SORT_SHIFT) || !defined(GNO_SORT_KEYS) || !defined(GNO_SORT_COUNTS)
#error "core/radix_sort.glsl: define GNO_SORT_LENGTH, GNO_SORT_SHIFT, GNO_SORT_KEYS and GNO_SORT_COUNTS before this file"
#endif
#if (GNO_SORT_RUNS) != GNO_SORT_PASS_COUNT
#if !defined(GNO_SORT_VALUES) || !defined(GNO_SORT_SORTED_KEYS) || !defined(GNO_SORT_SORTED_VALUES)
#error "core/radix_sort.glsl: define GNO_SORT_VALUES, GNO_SORT_SORTED_KEYS and GNO_SORT_SORTED_VALUES before this file"
#endif
#endif

shared uint gnoSortShared_[GNO_SORT_DIGITS * GNO_SORT_GROUP];  // digit by digit, in a digit invocation by invocation
shared uint gnoSortSums_[GNO_SORT_GROUP];

uint gnoSortDigit_(uint key_) { return (key_ >> GNO_SORT_SHIFT) & (GNO_SORT_DIGITS - 1u); }

// The invocation's own counters hold how often each digit occurs among its pairs.
void gnoSortCountOwn_(uint tile_, uint invocation_) {
    for (uint digit_ = 0u; digit_ < GNO_SORT_DIGITS; ++digit_) gnoSortShared_[digit_ * GNO_SORT_GROUP + invocation_] = 0u;
    uint first_ = tile_ * GNO_SORT_TILE + invocation_ * GNO_SORT_SHARE;
    for (uint i_ = first_; i_ < min(first_ + GNO_SORT_SHARE, GNO_SORT_LENGTH); ++i_) {
        gnoSortShared_[gnoSortDigit_(GNO_SORT_KEYS[i_]) * GNO_SORT_GROUP + invocation_] += 1u;
    }
    barrier();
}

// Four invocations to a digit add up a quarter of its counters each.
uint gnoSortQuarter_(uint invocation_) {
    uint sum_ = 0u;
    for (uint i_ = 0u; i_ < GNO_SORT_DIGITS; ++i_) sum_ += gnoSortShared_[invocation_ * GNO_SORT_DIGITS + i_];
    gnoSortSums_[invocation_] = sum_;
    barrier();
    return sum_;
}

#if (GNO_SORT_RUNS) & (1 | GNO_SORT_PASS_COUNT)
void gnoSortCount(uint tile_, uint invocation_) {
    gnoSortCountOwn_(tile_, invocation_);
    gnoSortQuarter_(invocation_);
    if (invocation_ < GNO_SORT_DIGITS) {
        uint at_ = 4u * invocation_;
        GNO_SORT_COUNTS[invocation_ * gnoSortTiles(GNO_SORT_LENGTH) + tile_] =
            gnoSortSums_[at_] + gnoSortSums_[at_ + 1u] + gnoSortSums_[at_ + 2u] + gnoSortSums_[at_ + 3u];
    }
}
#endif

#if (GNO_SORT_RUNS) & (1 | GNO_SORT_PASS_SCATTER)
void gnoSortScatter(uint tile_, uint invocation_) {
    gnoSortCountOwn_(tile_, invocation_);
    gnoSortQuarter_(invocation_);
    uint digit_ = invocation_ >> 2;
    uint place_ = GNO_SORT_COUNTS[digit_ * gnoSortTiles(GNO_SORT_LENGTH) + tile_];
    for (uint i_ = invocation_ & ~3u; i_ < invocation_; ++i_) place_ += gnoSortSums_[i_];
    for (uint i_ = 0u; i_ < GNO_SORT_DIGITS; ++i_) {  // a quarter of 64 invocations is as many as there are digits
        uint at_ = invocation_ * GNO_SORT_DIGITS + i_;
        uint count_ = gnoSortShared_[at_];
        gnoSortShared_[at_] = place_;
        place_ += count_;
    }
    barrier();
    uint first_ = tile_ * GNO_SORT_TILE + invocation_ * GNO_SORT_SHARE;
    for (uint i_ = first_; i_ < min(first_ + GNO_SORT_SHARE, GNO_SORT_LENGTH); ++i_) {
        uint key_ = GNO_SORT_KEYS[i_];
        uint at_ = gnoSortDigit_(key_) * GNO_SORT_GROUP + invocation_;
        uint to_ = gnoSortShared_[at_];
        gnoSortShared_[at_] = to_ + 1u;
        GNO_SORT_SORTED_KEYS[to_] = key_;
        GNO_SORT_SORTED_VALUES[to_] = GNO_SORT_VALUES[i_];
    }
}
#endif
#endif
