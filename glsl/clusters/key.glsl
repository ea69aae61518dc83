// SPDX-License-Identifier: MIT
// gnomon clusters/key.glsl : cluster keys and depth slices.
// After Sintorn et al., I3D 2014, equation 1 and figure 2.
//
//   uint  gnoClusterDeposit(uint value, uint mask)      the value's low bits at the mask's set bits, lowest first
//   uint  gnoClusterExtract(uint key, uint mask)        the reverse
//   uint  gnoClusterOrdered(float x)                    an unsigned integer that compares as x does (finite x, -0 below 0)
//   float gnoClusterFromOrdered(uint ordered)           the reverse
//   float gnoClusterDepth(GnoClusterFrame frame, vec3 p)            along the viewing direction, grid units; negative behind the viewer
//   float gnoClusterSliceStart(GnoClusterFrame frame, GnoClusterLayout layout, float least, float largest, uint slice)    slice 0 .. slices: where
//   it begins
//
// Slices are exponential, as deep as a tile is high: each begins 1 + 2 tan(half field of view) / (tiles in height) times as far away as the one
// before (equation 1), from the nearest view sample on. Where that takes more slices than a key has, the ratio is larger. Samples nearer than 2^-16
// of the farthest (or behind the viewer) share slice 0. An orthographic view has equal slices. A slice is looked up in the table of its beginnings,
// so every pass finds the same one, whatever the device's logarithm.
//
// Space      p on the scene grid
// Stages     any; pure
// Requires   #version 450, no extension
#ifndef GNO_CLUSTERS_KEY_GLSL
#define GNO_CLUSTERS_KEY_GLSL
#include "../core/light.glsl"
#include "cluster.h"
GNO_NAMESPACE_BEGIN

GNO_INLINE uint gnoClusterDeposit(uint value_, uint mask_) {
    uint result_ = 0u;
    while (mask_ != 0u) {
        uint lowest_ = mask_ & (0u - mask_);
        if ((value_ & 1u) != 0u) result_ |= lowest_;
        value_ >>= 1u;
        mask_ ^= lowest_;
    }
    return result_;
}

GNO_INLINE uint gnoClusterExtract(uint key_, uint mask_) {
    uint result_ = 0u;
    for (uint i_ = 0u; mask_ != 0u; ++i_) {
        uint lowest_ = mask_ & (0u - mask_);
        if ((key_ & lowest_) != 0u) result_ |= 1u << i_;
        mask_ ^= lowest_;
    }
    return result_;
}

GNO_INLINE uint gnoClusterOrdered(float x_) {
    uint bits_ = floatBitsToUint(x_);
    return (bits_ & 0x80000000u) != 0u ? ~bits_ : bits_ | 0x80000000u;
}

GNO_INLINE float gnoClusterFromOrdered(uint ordered_) {
    return uintBitsToFloat((ordered_ & 0x80000000u) != 0u ? ordered_ & 0x7FFFFFFFu : ~ordered_);
}

GNO_INLINE float gnoClusterDepth(GnoClusterFrame frame_, vec3 p_) {
    return gnoDot(vec3(frame_.forward.x, frame_.forward.y, frame_.forward.z), p_ - vec3(frame_.origin.x, frame_.origin.y, frame_.origin.z));
}

// Not decreasing in `slice`; slice 0 begins at the least depth and the end lies at the largest.
GNO_INLINE float gnoClusterSliceStart(GnoClusterFrame frame_, GnoClusterLayout layout_, float least_, float largest_, uint slice_) {
    uint slices_ = gnoClusterSlices(layout_);
    if (slice_ == 0u || !(largest_ > least_)) return slice_ == 0u ? least_ : largest_;
    float start_;
    if (frame_.origin.w == 0.0f) {
        float high_ = 2.0f * frame_.down.w / float(layout_.tiles.y);  // a tile's height
        start_ = least_ + max((largest_ - least_) / float(slices_), high_) * float(slice_);
    } else {
        float near_ = max(least_, largest_ * 1.52587890625e-5f);
        if (!(near_ > 0.0f)) return largest_;  // all behind the viewer
        float step_ = max(log2(1.0f + 2.0f * frame_.down.w / float(layout_.tiles.y)), log2(largest_ / near_) / float(slices_));
        start_ = near_ * exp2(step_ * float(slice_));
    }
    return slice_ >= slices_ ? largest_ : clamp(start_, least_, largest_);
}

GNO_NAMESPACE_END
#endif
