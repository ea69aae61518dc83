// SPDX-License-Identifier: MIT
// gnomon core/permutation.glsl : a random order of any number of things, without a list.
//
//   uint gnoPermute(uint index, uint count, uint seed)   bijective on [0, count) for every seed; index < count, count <= 2^31
//
// A keyed bijection of the next power of two (multiplications by odd numbers and xor-shifts are both invertible there), walked until it
// lands below count ("cycle walking"): fewer than two rounds on average.
//
// Space      none: no positions
// Stages     any; pure
// Requires   #version 450, no extension
#ifndef GNO_CORE_PERMUTATION_GLSL
#define GNO_CORE_PERMUTATION_GLSL
#include "shared_types.h"
GNO_NAMESPACE_BEGIN

GNO_INLINE uint gnoMix_(uint x_) {  // every bit of the result depends on every bit of x
    x_ = (x_ ^ (x_ >> 16)) * 0x7FEB352Du;
    x_ = (x_ ^ (x_ >> 15)) * 0x846CA68Bu;
    return x_ ^ (x_ >> 16);
}

GNO_INLINE uint gnoPermute(uint index_, uint count_, uint seed_) {
    if (count_ < 2u) return index_;
    uint mask_ = count_ - 1u;  // all ones up to the highest bit of count - 1
    mask_ |= mask_ >> 1;
    mask_ |= mask_ >> 2;
    mask_ |= mask_ >> 4;
    mask_ |= mask_ >> 8;
    mask_ |= mask_ >> 16;
    uint half_ = uint(bitCount(mask_) + 1) / 2u;  // the xor-shift brings the high half down
    uint x_ = index_;
    do {
        uint key_ = gnoMix_(seed_);  // the same bijection again: only the low bits of a round's two keys count, so each is mixed from the whole seed
        for (uint round_ = 0u; round_ < 4u; ++round_) {
            uint factor_ = gnoMix_(key_ + 0x9E3779B9u) | 1u;
            key_ = gnoMix_(key_ + 0x3C6EF372u);
            x_ = (x_ * factor_ + key_) & mask_;
            x_ ^= x_ >> half_;
        }
    } while (x_ >= count_);
    return x_;
}

GNO_NAMESPACE_END
#endif
