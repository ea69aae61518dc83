// SPDX-License-Identifier: MIT
// gnomon core/hit_weights.glsl : where the segment from the light to a point crosses a caster, as exact integer weights of its vertices.
//
//   uvec3 gnoHitWeights(vec4 light, GnoCaster t, vec3 p)     weights of t.a, t.b, t.c; p in the shadow volume of t (gnoInShadowOf)
//   uint  gnoWeightedMean(uvec3 weights, uvec3 values)       floor(sum of weight * value / sum of weights); no weight is above 2^22
//
// The hit point is h = (Wa a + Wb b + Wc c) / (Wa + Wb + Wc) with
//   Wa = |orient3d(light, b, c, p)|, Wb = |orient3d(light, c, a, p)|, Wc = |orient3d(light, a, b, p)|, in units of 2^-120,
// the determinants whose signs core/orient3d.glsl asks for (w = 0: the limit of a light far away). They are computed exactly. The weights are
// those three numbers shifted right by the one least amount after which each is below 2^22, so their sum is below 3 * 2^22 < 2^24; where all
// three are smaller than that already nothing is shifted. The weights are the definition of the hit point from here on: integers, equal on
// every device, within 2^-20 of the real barycentric coordinates.
//
// Space      light, t and p as in core/orient3d.glsl
// Bits       with l = light - w p and a, b, c less p, Wa = |l . (b x c)| and so on. Each is a determinant of differences, hence at most
//            4 * 27 * 2^120 < 2^127 (core/int128.glsl) and its absolute value fits 127 bits. The weights' bit length is taken from their bitwise
//            or, so no sum of large numbers is formed. In a shadow volume the three have one sign, their sum is |l . ((b - a) x (c - a))|, which is
//            not zero as light and p lie strictly on two sides of t, and the shift keeps the highest bit of the largest: not all weights are 0.
//            Elsewhere the same integers come out, without a meaning; all three may be 0, and gnoWeightedMean is then 0
// Stages     any; may diverge; pure
// Requires   #version 450, no extension, no optional device feature (no int64, no fp64)
// Reads      nothing; writes nothing; declares no binding
// Cost       81 umulExtended, about two and a half exact signs of core/orient3d.glsl; gnoWeightedMean: 3 umulExtended, 4 divisions
//
// No macros.
#ifndef GNO_CORE_HIT_WEIGHTS_GLSL
#define GNO_CORE_HIT_WEIGHTS_GLSL
#include "int128.glsl"
#include "portable.h"
#include "shared_types.h"

// |x| for two's complement x > -2^127.
uvec4 gnoAbsolute_(uvec4 x_) {
    uint sign_ = uint(int(x_.w) >> 31);
    uint c0_, c1_, c2_;
    uvec4 result_;
    result_.x = uaddCarry(x_.x ^ sign_, sign_ & 1u, c0_);
    result_.y = uaddCarry(x_.y ^ sign_, c0_, c1_);
    result_.z = uaddCarry(x_.z ^ sign_, c1_, c2_);
    result_.w = (x_.w ^ sign_) + c2_;
    return result_;
}

// The number of bits of x: 0 for 0.
uint gnoBitLength_(uvec4 x_) {
    if (x_.w != 0u) return uint(findMSB(x_.w)) + 97u;
    if (x_.z != 0u) return uint(findMSB(x_.z)) + 65u;
    if (x_.y != 0u) return uint(findMSB(x_.y)) + 33u;
    return uint(findMSB(x_.x) + 1);
}

// The lowest word of x >> shift; shift < 128.
uint gnoShiftedWord_(uvec4 x_, uint shift_) {
    uint words_ = shift_ >> 5u;
    uint low_ = words_ == 0u ? x_.x : (words_ == 1u ? x_.y : (words_ == 2u ? x_.z : x_.w));
    uint high_ = words_ == 0u ? x_.y : (words_ == 1u ? x_.z : (words_ == 2u ? x_.w : 0u));
    uint bits_ = shift_ & 31u;
    return (low_ >> bits_) | ((high_ << 1u) << (31u - bits_));
}

uvec3 gnoHitWeights(vec4 light_, GnoCaster t_, vec3 p_) {
    GnoInt64x3_ l_ = gnoDifference_(vec3(light_), light_.w * p_);  // w is 0 or 1: the product is exact
    GnoInt64x3_ a_ = gnoDifference_(t_.a, p_);
    GnoInt64x3_ b_ = gnoDifference_(t_.b, p_);
    GnoInt64x3_ c_ = gnoDifference_(t_.c, p_);
    GnoInt96x3_ la_ = gnoCross_(l_, a_);
    uvec4 wa_ = gnoAbsolute_(gnoDot_(gnoCross_(b_, c_), l_));
    uvec4 wb_ = gnoAbsolute_(gnoDot_(la_, c_));
    uvec4 wc_ = gnoAbsolute_(gnoDot_(la_, b_));
    uint shift_ = max(gnoBitLength_(wa_ | wb_ | wc_), 22u) - 22u;
    return uvec3(gnoShiftedWord_(wa_, shift_), gnoShiftedWord_(wb_, shift_), gnoShiftedWord_(wc_, shift_));
}

// Long division of the 64-bit sum of products, a byte at a time. The mean is at most the largest value, below 2^32, so the products' high word is
// below the divisor to begin with; remainders stay below the divisor, below 2^24, and a byte fits behind them.
uint gnoWeightedMean(uvec3 weights_, uvec3 values_) {
    uint divisor_ = weights_.x + weights_.y + weights_.z;
    if (divisor_ == 0u) return 0u;
    uvec3 high_, low_;
    umulExtended(weights_, values_, high_, low_);
    uint c0_, c1_;
    uint rest_ = uaddCarry(uaddCarry(low_.x, low_.y, c0_), low_.z, c1_);
    uint remainder_ = high_.x + high_.y + high_.z + c0_ + c1_;
    uint quotient_ = 0u;
    for (int i_ = 0; i_ < 4; ++i_) {
        uint dividend_ = (remainder_ << 8u) | (rest_ >> 24u);
        uint digit_ = dividend_ / divisor_;
        remainder_ = dividend_ - digit_ * divisor_;
        quotient_ = (quotient_ << 8u) | digit_;
        rest_ <<= 8u;
    }
    return quotient_;
}

#endif
