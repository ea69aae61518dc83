// SPDX-License-Identifier: MIT
// gnomon core/int128.glsl : just enough exact integer arithmetic for core/orient3d.glsl, three components at a time.
//
//   GnoInt64x3_  gnoDifference_(vec3 x, vec3 y)                 (x - y) * 2^40
//   GnoInt96x3_  gnoCross_(GnoInt64x3_ x, GnoInt64x3_ y)        cross product
//   uvec4        gnoDot_(GnoInt96x3_ x, GnoInt64x3_ y)          dot product, lowest word first
//   int          gnoSign_(uvec4 x)                              -1, 0 or 1
//
// Space      positions on the scene grid, with room for samples that were moved off their surface
// Numbers    two's complement in 32-bit words, w0_ the lowest; all sums and products are taken modulo 2^words, so that only the results have to fit
// Widths     coordinates |x| <= 1.5, multiples of 2^-40: below 2^41; differences at most 3 * 2^40 < 2^42; minors at most 2 * 9 * 2^80 < 2^85
//            (96 bits hold them); determinants at most 4 * 27 * 2^120 < 2^127 (a 3x3 determinant with entries in [-m, m] is at most 4 m^3)
// Stages     any
// Requires   #version 450, no extension, no optional device feature (no int64, no fp64)
// Reads      nothing; writes nothing; declares no binding
// Cost       a product of 3 pairs: 9 umulExtended (gnoMultiply_) or 15 (gnoDot_)
//
// No macros.
#ifndef GNO_CORE_INT128_GLSL
#define GNO_CORE_INT128_GLSL

struct GnoInt64x3_ {
    uvec3 w0_;
    uvec3 w1_;
};

struct GnoInt96x3_ {
    uvec3 w0_;
    uvec3 w1_;
    uvec3 w2_;
};

uvec3 gnoYzx_(uvec3 v_) { return uvec3(v_.y, v_.z, v_.x); }
uvec3 gnoZxy_(uvec3 v_) { return uvec3(v_.z, v_.x, v_.y); }
uvec3 gnoSignMask_(uvec3 v_) { return uvec3(ivec3(v_) >> 31); }

// v * 2^40 from the bits of v: no float arithmetic, hence no rounding and no flushed denormal. v = mantissa * 2^(exponent - 150). A zero has
// exponent 0: its mantissa is shifted out.
GnoInt64x3_ gnoFixed_(vec3 v_) {
    uvec3 bits_ = floatBitsToUint(v_);
    uvec3 sign_ = gnoSignMask_(bits_);
    uvec3 exponent_ = (bits_ >> 23u) & uvec3(255u);
    uvec3 right_ = min(uvec3(110u) - min(exponent_, uvec3(110u)), uvec3(31u));
    uvec3 left_ = max(exponent_, uvec3(110u)) - uvec3(110u);  // at most 17; not zero only where right_ is
    uvec3 mantissa_ = ((bits_ & uvec3(0x007FFFFFu)) | uvec3(0x00800000u)) >> right_;
    uvec3 carry_;
    GnoInt64x3_ result_;
    result_.w0_ = uaddCarry((mantissa_ << left_) ^ sign_, sign_ & uvec3(1u), carry_);  // negated where sign_ is all ones
    result_.w1_ = (((mantissa_ >> (uvec3(31u) - left_)) >> 1u) ^ sign_) + carry_;
    return result_;
}

GnoInt64x3_ gnoDifference_(vec3 x_, vec3 y_) {
    GnoInt64x3_ a_ = gnoFixed_(x_);
    GnoInt64x3_ b_ = gnoFixed_(y_);
    uvec3 borrow_;
    a_.w0_ = usubBorrow(a_.w0_, b_.w0_, borrow_);
    a_.w1_ = a_.w1_ - b_.w1_ - borrow_;
    return a_;
}

// As unsigned words x = X - 2^64 [x < 0], so that x * y = X * Y - 2^64 ([x < 0] Y + [y < 0] X) modulo 2^96.
GnoInt96x3_ gnoMultiply_(GnoInt64x3_ x_, GnoInt64x3_ y_) {
    uvec3 h00_, l00_, h01_, l01_, h10_, l10_, c0_, c1_;
    umulExtended(x_.w0_, y_.w0_, h00_, l00_);
    umulExtended(x_.w0_, y_.w1_, h01_, l01_);
    umulExtended(x_.w1_, y_.w0_, h10_, l10_);
    GnoInt96x3_ result_;
    result_.w0_ = l00_;
    result_.w1_ = uaddCarry(uaddCarry(h00_, l01_, c0_), l10_, c1_);
    result_.w2_ = x_.w1_ * y_.w1_ + h01_ + h10_ + c0_ + c1_ - (gnoSignMask_(x_.w1_) & y_.w0_) - (gnoSignMask_(y_.w1_) & x_.w0_);
    return result_;
}

GnoInt64x3_ gnoRotateYzx_(GnoInt64x3_ x_) {
    GnoInt64x3_ result_;
    result_.w0_ = gnoYzx_(x_.w0_);
    result_.w1_ = gnoYzx_(x_.w1_);
    return result_;
}

GnoInt64x3_ gnoRotateZxy_(GnoInt64x3_ x_) {
    GnoInt64x3_ result_;
    result_.w0_ = gnoZxy_(x_.w0_);
    result_.w1_ = gnoZxy_(x_.w1_);
    return result_;
}

GnoInt96x3_ gnoCross_(GnoInt64x3_ x_, GnoInt64x3_ y_) {
    GnoInt96x3_ p_ = gnoMultiply_(gnoRotateYzx_(x_), gnoRotateZxy_(y_));
    GnoInt96x3_ q_ = gnoMultiply_(gnoRotateZxy_(x_), gnoRotateYzx_(y_));
    uvec3 b0_, b1_, b2_;
    GnoInt96x3_ result_;
    result_.w0_ = usubBorrow(p_.w0_, q_.w0_, b0_);
    result_.w1_ = usubBorrow(usubBorrow(p_.w1_, q_.w1_, b1_), b0_, b2_);
    result_.w2_ = p_.w2_ - q_.w2_ - b1_ - b2_;
    return result_;
}

uvec4 gnoAdd_(uvec4 x_, uvec4 y_) {
    uint c0_, c1_, c2_, c3_, c4_;
    uvec4 result_;
    result_.x = uaddCarry(x_.x, y_.x, c0_);
    result_.y = uaddCarry(uaddCarry(x_.y, y_.y, c1_), c0_, c2_);
    result_.z = uaddCarry(uaddCarry(x_.z, y_.z, c3_), c1_ + c2_, c4_);  // c1_ and c2_ are never both 1
    result_.w = x_.w + y_.w + c3_ + c4_;
    return result_;
}

// The products are unsigned words corrected for the signs, as in gnoMultiply_: x = X - 2^96 [x < 0], y = Y - 2^64 [y < 0], modulo 2^128.
uvec4 gnoDot_(GnoInt96x3_ x_, GnoInt64x3_ y_) {
    uvec3 h00_, l00_, h01_, l01_, h10_, l10_, h11_, l11_, h20_, l20_, c0_, c1_, c2_, c3_, c4_, c5_, c6_;
    umulExtended(x_.w0_, y_.w0_, h00_, l00_);
    umulExtended(x_.w0_, y_.w1_, h01_, l01_);
    umulExtended(x_.w1_, y_.w0_, h10_, l10_);
    umulExtended(x_.w1_, y_.w1_, h11_, l11_);
    umulExtended(x_.w2_, y_.w0_, h20_, l20_);
    uvec3 signX_ = gnoSignMask_(x_.w2_);
    uvec3 signY_ = gnoSignMask_(y_.w1_);
    uvec3 w1_ = uaddCarry(uaddCarry(h00_, l01_, c0_), l10_, c1_);
    uvec3 w2_ = uaddCarry(uaddCarry(h01_, h10_, c2_), c0_ + c1_, c3_);
    w2_ = uaddCarry(uaddCarry(w2_, l11_, c4_), l20_, c5_);
    w2_ = usubBorrow(w2_, signY_ & x_.w0_, c6_);
    uvec3 w3_ = h11_ + h20_ + x_.w2_ * y_.w1_ + c2_ + c3_ + c4_ + c5_ - c6_ - (signY_ & x_.w1_) - (signX_ & y_.w0_);
    uvec4 sum_ = gnoAdd_(uvec4(l00_.x, w1_.x, w2_.x, w3_.x), uvec4(l00_.y, w1_.y, w2_.y, w3_.y));
    return gnoAdd_(sum_, uvec4(l00_.z, w1_.z, w2_.z, w3_.z));
}

int gnoSign_(uvec4 x_) { return int(x_.w) < 0 ? -1 : ((x_.x | x_.y | x_.z | x_.w) != 0u ? 1 : 0); }

#endif
