// SPDX-License-Identifier: MIT
// gnomon core/orient3d.glsl : exact signs of determinants of grid positions, and the definition of "in shadow" made of them.
//
//   int  gnoOrient3d(vec3 o, vec3 a, vec3 b, vec3 c)                               sign of det[a - o, b - o, c - o]: -1, 0 or 1
//   int  gnoOrient3dLight(vec4 light, vec3 a, vec3 b, vec3 c)                      w = 1: gnoOrient3d(light, a, b, c); w = 0: -sign det[light, b -
//   a, c - a]
//   int  gnoFacing(vec4 light, GnoCaster t)                                        gnoOrient3dLight(light, t.a, t.b, t.c); 0: edge-on, casts nothing
//   bool gnoInShadowOf(vec4 light, GnoCaster t, vec3 p)                            true: t shadows p (README "What in shadow means", 1 to 3)
//   bool gnoInShadowOfFacing(vec4 light, GnoCaster t, vec3 p, int facing)          the same where gnoFacing(light, t) is known already
//   vec3 gnoExactNormal(GnoCaster t)                                               (b - a) x (c - a): each component within 2^-22 of its exact
//   value,
//                                                                                  times a power of two that brings the largest into [0.5, 1);
//                                                                                  zero if and only if a, b, c are exactly collinear
//
// Space      positions: fp32 multiples of 2^-40 with |x| <= 1.5 (the scene's grid, and room for samples that were moved off their surface);
//            light: w = 1 and such a position, or w = 0 and the direction towards the light, also multiples of 2^-40
// Sides      for the volume of t: gnoOrient3dLight(light, t.a, t.b, p) and its two rotations are the lateral signs, gnoOrient3d(t.a, t.b, t.c, p)
//            the capping sign
// Stages     any; may diverge
// Requires   #version 450, no extension, no optional device feature (no fp64, no int64); any rounding mode, denormals kept or flushed
// Reads      nothing; writes nothing; declares no binding
// Cost       the filter of one sign: 3 subtractions of vec3, about 30 flops; an exact sign: 33 umulExtended and about 500 other integer operations,
//            only where the filter cannot tell. gnoInShadowOfFacing: about 110 flops for its four signs, then one exact sign after the other
//            for those that the filter left open
//
// Macro                        required  default  meaning
// GNO_ORIENT3D_FILTER          no        1        1: ask fp32 first; 0: always the exact integers (same answers; for tests)
// GNO_ORIENT3D_ON_EXACT        no        nothing  a statement that runs before each exact sign (to count them)
#ifndef GNO_CORE_ORIENT3D_GLSL
#define GNO_CORE_ORIENT3D_GLSL
#include "int128.glsl"
#include "portable.h"
#include "shared_types.h"
#ifndef GNO_ORIENT3D_FILTER
#define GNO_ORIENT3D_FILTER 1
#endif
#ifndef GNO_ORIENT3D_ON_EXACT
#define GNO_ORIENT3D_ON_EXACT
#endif

// The filter. Every determinant below is evaluated as x . (y cross z) with x, y, z differences of positions. With any rounding mode each
// operation returns its exact result times (1 + d), |d| <= u = 2^-23, because nothing here is ever a denormal: differences are multiples of
// 2^-40, products of two and their sums multiples of 2^-80, products of three and their sums multiples of 2^-120 (rounding to 24 bits keeps
// that), so each is 0 or at least 2^-120 > 2^-126.
// Each of the six monomials passes 3 differences, a product, a subtraction, a product and up to 2 additions: at most 8 factors 1 + d. So
//   |computed - det| <= ((1 + u)^8 - 1) P <= 8.0001 u P,   P = the sum of the absolute values of the exact monomials.
// `magnitude` is P evaluated by the same operations, all terms positive: P <= magnitude / (1 - u)^8 <= (1 + 8.0001 u) magnitude.
// GNO_ORIENT3D_BOUND_ * magnitude, rounded once more, is therefore an upper bound with 8.5 u in place of 8.0001 u (1 + 9.0002 u) < 8.01 u.
// Only that product may be a denormal, and be flushed: then magnitude < 2^-106, the error is below 2^-126, and, as both det and its computed
// value are multiples of 2^-120, it is 0; a bound of 0 is right.
// magnitude = 0 means that every monomial is exactly 0 (nothing underflows), hence det = 0: this is certain, too.
// Contraction of a product and a sum would only remove factors 1 + d; `precise` makes all compilers agree to the bit nevertheless.
const float GNO_ORIENT3D_BOUND_ = 17.0f / 16777216.0f;  // 8.5 * 2^-23

vec3 gnoYzxFloat_(vec3 v_) { return vec3(v_.y, v_.z, v_.x); }
vec3 gnoZxyFloat_(vec3 v_) { return vec3(v_.z, v_.x, v_.y); }

// y cross z, and the same with all terms positive.
void gnoCrossFilter_(vec3 y_, vec3 z_, GNO_OUT(vec3) cross_, GNO_OUT(vec3) magnitude_) {
    precise vec3 p_ = gnoYzxFloat_(y_) * gnoZxyFloat_(z_);
    precise vec3 q_ = gnoZxyFloat_(y_) * gnoYzxFloat_(z_);
    precise vec3 difference_ = p_ - q_;
    precise vec3 sum_ = abs(p_) + abs(q_);
    cross_ = difference_;
    magnitude_ = sum_;
}

float gnoDotFilter_(vec3 x_, vec3 y_) {
    precise vec3 t_ = x_ * y_;
    precise float sum_ = (t_.x + t_.y) + t_.z;
    return sum_;
}

// light - p, or the direction itself: one rounding either way (w is 0 or 1, so w * p is exact).
vec3 gnoLightDifference_(vec4 light_, vec3 p_) {
    precise vec3 difference_ = vec3(light_) - light_.w * p_;
    return difference_;
}

vec3 gnoDifferenceFloat_(vec3 x_, vec3 y_) {
    precise vec3 difference_ = x_ - y_;
    return difference_;
}

// Sign of det[x, y, z] of rounded differences; 2 = cannot tell.
int gnoFilteredSign_(vec3 x_, vec3 y_, vec3 z_) {
    vec3 cross_, crossMagnitude_;
    gnoCrossFilter_(y_, z_, cross_, crossMagnitude_);
    float det_ = gnoDotFilter_(x_, cross_);
    float magnitude_ = gnoDotFilter_(abs(x_), crossMagnitude_);
    float bound_ = GNO_ORIENT3D_BOUND_ * magnitude_;
    return det_ > bound_ ? 1 : (det_ < -bound_ ? -1 : (magnitude_ == 0.0f ? 0 : 2));
}

// Sign of det[x - xFrom, y - from, z - from].
int gnoExactSign_(vec3 x_, vec3 xFrom_, vec3 y_, vec3 z_, vec3 from_) {
    GNO_ORIENT3D_ON_EXACT;
    return gnoSign_(gnoDot_(gnoCross_(gnoDifference_(y_, from_), gnoDifference_(z_, from_)), gnoDifference_(x_, xFrom_)));
}

int gnoOrient3d(vec3 o_, vec3 a_, vec3 b_, vec3 c_) {
#if GNO_ORIENT3D_FILTER
    int sign_ = gnoFilteredSign_(gnoDifferenceFloat_(a_, o_), gnoDifferenceFloat_(b_, o_), gnoDifferenceFloat_(c_, o_));
    if (sign_ != 2) {
        return sign_;
    }
#endif
    return gnoExactSign_(a_, o_, b_, c_, o_);
}

// det[a - L, b - L, c - L] = -det[L - a, b - a, c - a]: one formula for both kinds of light.
int gnoOrient3dLight(vec4 light_, vec3 a_, vec3 b_, vec3 c_) {
#if GNO_ORIENT3D_FILTER
    int sign_ = gnoFilteredSign_(gnoLightDifference_(light_, a_), gnoDifferenceFloat_(b_, a_), gnoDifferenceFloat_(c_, a_));
    if (sign_ != 2) {
        return -sign_;
    }
#endif
    return -gnoExactSign_(vec3(light_), light_.w * a_, b_, c_, a_);
}

int gnoFacing(vec4 light_, GnoCaster t_) { return gnoOrient3dLight(light_, t_.a, t_.b, t_.c); }

// Everything relative to p: with a, b, c the vertices minus p and l = L - w p, the lateral signs are those of -det[l, a, b], -det[l, b, c],
// -det[l, c, a] (expand det[a - l, b - l, -l]), and p is strictly behind t if and only if -det[a, b, c] = orient3d(A, B, C, p) has the sign of
// `facing`, since orient3d(A, B, C, L) has the opposite one. So all four, times `facing`, have to be positive; the lateral ones may be 0.
bool gnoInShadowOfFacing(vec4 light_, GnoCaster t_, vec3 p_, int facing_) {
    uint open_ = 15u;  // signs that are not known yet: 1, 2, 4 the lateral planes through ab, bc, ca; 8 the capping plane
    bool inside_ = facing_ != 0;
#if GNO_ORIENT3D_FILTER
    vec3 l_ = gnoLightDifference_(light_, p_);
    vec3 a_ = gnoDifferenceFloat_(t_.a, p_);
    vec3 b_ = gnoDifferenceFloat_(t_.b, p_);
    vec3 c_ = gnoDifferenceFloat_(t_.c, p_);
    vec3 ab_, abMagnitude_, lc_, lcMagnitude_;
    gnoCrossFilter_(a_, b_, ab_, abMagnitude_);
    gnoCrossFilter_(l_, c_, lc_, lcMagnitude_);
    vec4 side_ = float(facing_) * vec4(-gnoDotFilter_(l_, ab_), gnoDotFilter_(b_, lc_), -gnoDotFilter_(a_, lc_), -gnoDotFilter_(c_, ab_));
    vec4 magnitude_ = vec4(gnoDotFilter_(abs(l_), abMagnitude_), gnoDotFilter_(abs(b_), lcMagnitude_), gnoDotFilter_(abs(a_), lcMagnitude_),
                           gnoDotFilter_(abs(c_), abMagnitude_));
    vec4 bound_ = GNO_ORIENT3D_BOUND_ * magnitude_;
    inside_ = inside_ && magnitude_.w != 0.0f && !any(lessThan(side_, -bound_));
    open_ = (side_.x > bound_.x || magnitude_.x == 0.0f ? 0u : 1u) | (side_.y > bound_.y || magnitude_.y == 0.0f ? 0u : 2u) |
            (side_.z > bound_.z || magnitude_.z == 0.0f ? 0u : 4u) | (side_.w > bound_.w ? 0u : 8u);
#endif
    while (inside_ && open_ != 0u) {  // the highest bit first: a large receiver has its samples on the capping planes of its neighbours
        bool cap_ = open_ >= 8u;
        bool ca_ = open_ >= 4u;
        bool bc_ = open_ >= 2u;
        vec3 x_ = cap_ ? t_.a : vec3(light_);
        vec3 xFrom_ = cap_ ? p_ : light_.w * p_;
        vec3 y_ = cap_ ? t_.b : (ca_ ? t_.c : (bc_ ? t_.b : t_.a));
        vec3 z_ = cap_ ? t_.c : (ca_ ? t_.a : (bc_ ? t_.c : t_.b));
        int sign_ = -facing_ * gnoExactSign_(x_, xFrom_, y_, z_, p_);
        inside_ = sign_ > 0 || (sign_ == 0 && !cap_);
        open_ &= cap_ ? 7u : (ca_ ? 3u : (bc_ ? 1u : 0u));
    }
    return inside_;
}

bool gnoInShadowOf(vec4 light_, GnoCaster t_, vec3 p_) { return gnoInShadowOfFacing(light_, t_, p_, gnoFacing(light_, t_)); }

// The highest bit of a 96-bit number, -1 for zero; top_ gets the 24 bits from there on, left-aligned to bit 23.
int gnoTopBits_(uint w0_, uint w1_, uint w2_, GNO_OUT(uint) top_) {
    bool skip2_ = w2_ == 0u;
    bool skip1_ = skip2_ && w1_ == 0u;
    uint high_ = skip1_ ? w0_ : (skip2_ ? w1_ : w2_);
    uint low_ = skip1_ ? 0u : (skip2_ ? w0_ : w1_);
    int bit_ = findMSB(high_);
    uint shift_ = uint(31 - max(bit_, 0));
    top_ = ((high_ << shift_) | ((low_ >> 1u) >> (31u - shift_))) >> 8u;
    return bit_ < 0 ? -1 : bit_ + (skip1_ ? 0 : (skip2_ ? 32 : 64));
}

// (-1)^negative * top * 2^(bit - 24 - largest) as the bits of a float; truncated to 24 bits: relative error below 2^-23.
float gnoScaledFloat_(int bit_, uint top_, uint sign_, int largest_) {
    uint exponent_ = uint(126 + bit_ - largest_);  // bit = largest: [0.5, 1); at least 126 - 85, so never a denormal
    return bit_ < 0 ? 0.0f : uintBitsToFloat((sign_ & 0x80000000u) | (exponent_ << 23u) | (top_ & 0x007FFFFFu));
}

vec3 gnoExactNormal(GnoCaster t_) {
    GnoInt96x3_ n_ = gnoCross_(gnoDifference_(t_.b, t_.a), gnoDifference_(t_.c, t_.a));
    uvec3 sign_ = gnoSignMask_(n_.w2_);
    uvec3 c0_, c1_, top_;
    uvec3 w0_ = uaddCarry(n_.w0_ ^ sign_, sign_ & uvec3(1u), c0_);
    uvec3 w1_ = uaddCarry(n_.w1_ ^ sign_, c0_, c1_);
    uvec3 w2_ = (n_.w2_ ^ sign_) + c1_;
    int x_ = gnoTopBits_(w0_.x, w1_.x, w2_.x, top_.x);
    int y_ = gnoTopBits_(w0_.y, w1_.y, w2_.y, top_.y);
    int z_ = gnoTopBits_(w0_.z, w1_.z, w2_.z, top_.z);
    int largest_ = max(x_, max(y_, z_));
    return vec3(gnoScaledFloat_(x_, top_.x, sign_.x, largest_), gnoScaledFloat_(y_, top_.y, sign_.y, largest_),
                gnoScaledFloat_(z_, top_.z, sign_.z, largest_));
}

#endif
