// SPDX-License-Identifier: MIT
// gnomon core/transmittance_sum.glsl : one sum of contributions (core/transmittance.glsl) per pixel and channel, added to by anyone in any order.
//
//   void  gnoAddTransmittance(uint pixel, uvec3 contribution)   atomic; each component at most GNO_TRANSMITTANCE_OPAQUE
//   void  gnoAddOpaque(uint pixel)                              atomic; the same as GNO_TRANSMITTANCE_OPAQUE thrice
//   bool  gnoIsDark(uint pixel)                                 all three sums are at the stop: nothing can change any more. A pass that adds may
//                                                               see it late, and may skip a caster when it sees it
//   uvec3 gnoTransmittanceSum(uint pixel)                       the sums, min(sum, GNO_TRANSMITTANCE_OPAQUE); in a dispatch after those that add
//
// Why no number of layers can wrap a sum: whoever adds learns what was there before (atomicAdd). Before a sum passes 2^32 it passes
// GNO_TRANSMITTANCE_OPAQUE = 2^20, as no contribution is larger than that; the one addition that passes it sets the channel's bit in the pixel's
// fourth word, and a bit that is set stays set. With the bit the sum's own word has no meaning any more, and is added to no longer.
//
// Space      none: no positions
// Stages     any with storage buffers; writable where it adds (fragment stage: fragmentStoresAndAtomics)
// Requires   #version 450, no extension. The buffer is all zero before the first addition
// Reads      and writes GNO_TRANSMITTANCE_SUMS; atomic but for gnoTransmittanceSum
//
// Macro                         required  default  meaning
// GNO_TRANSMITTANCE_ADDS        no        1        0: only gnoTransmittanceSum is there, and the sums may be read-only
// GNO_TRANSMITTANCE_SUMS        yes       -        uint array in a buffer (an l-value), 4 per pixel: three sums, and bits 0 to 2 where they are at
//                                                  the stop
#ifndef GNO_CORE_TRANSMITTANCE_SUM_GLSL
#define GNO_CORE_TRANSMITTANCE_SUM_GLSL
#include "material.h"
#ifndef GNO_TRANSMITTANCE_ADDS
#define GNO_TRANSMITTANCE_ADDS 1
#endif
#ifndef GNO_TRANSMITTANCE_SUMS
#error "core/transmittance_sum.glsl: define GNO_TRANSMITTANCE_SUMS or include core/material_bindings.glsl before this file"
#endif

#if GNO_TRANSMITTANCE_ADDS
void gnoAddOpaque(uint pixel_) { atomicOr(GNO_TRANSMITTANCE_SUMS[4u * pixel_ + 3u], 7u); }

bool gnoIsDark(uint pixel_) { return atomicOr(GNO_TRANSMITTANCE_SUMS[4u * pixel_ + 3u], 0u) == 7u; }  // others may set bits meanwhile

// The bit that the channel has to set, if any.
uint gnoAddChannel_(uint pixel_, uint channel_, uint contribution_) {
    if (contribution_ == 0u) return 0u;
    if (contribution_ >= GNO_TRANSMITTANCE_OPAQUE) return 1u << channel_;
    uint before_ = atomicAdd(GNO_TRANSMITTANCE_SUMS[4u * pixel_ + channel_], contribution_);
    return before_ < GNO_TRANSMITTANCE_OPAQUE && before_ + contribution_ >= GNO_TRANSMITTANCE_OPAQUE ? 1u << channel_ : 0u;
}

void gnoAddTransmittance(uint pixel_, uvec3 contribution_) {
    uint stopped_ = atomicOr(GNO_TRANSMITTANCE_SUMS[4u * pixel_ + 3u], 0u);  // others may set bits meanwhile
    uint stop_ = 0u;
    if ((stopped_ & 1u) == 0u) stop_ |= gnoAddChannel_(pixel_, 0u, contribution_.x);
    if ((stopped_ & 2u) == 0u) stop_ |= gnoAddChannel_(pixel_, 1u, contribution_.y);
    if ((stopped_ & 4u) == 0u) stop_ |= gnoAddChannel_(pixel_, 2u, contribution_.z);
    if (stop_ != 0u) atomicOr(GNO_TRANSMITTANCE_SUMS[4u * pixel_ + 3u], stop_);
}
#endif

uvec3 gnoTransmittanceSum(uint pixel_) {
    uint stopped_ = GNO_TRANSMITTANCE_SUMS[4u * pixel_ + 3u];
    return uvec3((stopped_ & 1u) != 0u ? GNO_TRANSMITTANCE_OPAQUE : GNO_TRANSMITTANCE_SUMS[4u * pixel_],
                 (stopped_ & 2u) != 0u ? GNO_TRANSMITTANCE_OPAQUE : GNO_TRANSMITTANCE_SUMS[4u * pixel_ + 1u],
                 (stopped_ & 4u) != 0u ? GNO_TRANSMITTANCE_OPAQUE : GNO_TRANSMITTANCE_SUMS[4u * pixel_ + 2u]);
}

#endif
