// SPDX-License-Identifier: MIT
// gnomon core/prefix_sum.glsl : exclusive prefix sums, within a work group and by one work group over an array.
//
//   uint gnoGroupPrefix(uint value, uint invocation, out uint total)      the sum of the values of all earlier invocations of the work group
//   uint gnoArrayPrefix(uint count, uint invocation)                      GNO_PREFIX_WORDS[0 .. count) become their prefix sums; the total is
//   returned
//
// Both are called by all GNO_PREFIX_GROUP invocations of a work group in uniform control flow. gnoArrayPrefix is for one work group alone: nothing
// waits for another one, on any device, and the array's sums are there for the next dispatch. It is meant for the short arrays of sums that many
// work groups leave behind.
//
// Space      none: no positions
// Stages     compute; holds barriers
// Requires   #version 450, no extension, any subgroup width
// Cost       4 bytes of shared memory and 2 log2 GNO_PREFIX_GROUP barriers; gnoArrayPrefix reads the array twice and writes it once
//
// Macro                 required  default  meaning
// GNO_PREFIX_GROUP      no        64u      invocations of the work group, a power of two; the same wherever it is given
// GNO_PREFIX_WORDS      no        -        array of uint in a storage buffer; needed for gnoArrayPrefix
#ifndef GNO_CORE_PREFIX_SUM_GLSL
#define GNO_CORE_PREFIX_SUM_GLSL
#include "portable.h"
#include "shared_types.h"
#ifndef GNO_PREFIX_GROUP
#define GNO_PREFIX_GROUP 64u
#endif

shared uint gnoPrefixShared_[GNO_PREFIX_GROUP];

uint gnoGroupPrefix(uint value_, uint invocation_, GNO_OUT(uint) total_) {
    barrier();  // an earlier call may still be read
    gnoPrefixShared_[invocation_] = value_;
    barrier();
    for (uint reach_ = 1u; reach_ < GNO_PREFIX_GROUP; reach_ <<= 1) {
        uint before_ = invocation_ >= reach_ ? gnoPrefixShared_[invocation_ - reach_] : 0u;
        barrier();
        gnoPrefixShared_[invocation_] += before_;
        barrier();
    }
    total_ = gnoPrefixShared_[GNO_PREFIX_GROUP - 1u];
    return gnoPrefixShared_[invocation_] - value_;
}

#ifdef GNO_PREFIX_WORDS
uint gnoArrayPrefix(uint count_, uint invocation_) {
    uint share_ = (count_ + GNO_PREFIX_GROUP - 1u) / GNO_PREFIX_GROUP;
    uint first_ = min(invocation_ * share_, count_);
    uint end_ = min(first_ + share_, count_);
    uint sum_ = 0u;
    for (uint i_ = first_; i_ < end_; ++i_) sum_ += GNO_PREFIX_WORDS[i_];
    uint total_;
    uint before_ = gnoGroupPrefix(sum_, invocation_, total_);
    for (uint i_ = first_; i_ < end_; ++i_) {
        uint word_ = GNO_PREFIX_WORDS[i_];
        GNO_PREFIX_WORDS[i_] = before_;
        before_ += word_;
    }
    return total_;
}
#endif
#endif
