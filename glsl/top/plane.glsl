// SPDX-License-Identifier: MIT
// gnomon top/plane.glsl : the planes of a shadow volume, how far fp32 can be trusted with them, and bounds of what lies behind a caster.
// After Mora et al., EGSR 2016, section 3.1 (figure 2); margins, bands and bounds are this project's, derived below.
//
//   vec4  gnoTopLateralPlane(vec4 light, vec3 a, vec3 b, int facing, uint precision)   through the light and edge ab; inside is negative
//   bool  gnoTopSubstitute(vec4 light, GnoCaster t, uint place, out vec4 plane)        for a lateral plane that fp32 cannot tell: one that only
//   routes (8)
//   vec4  gnoTopCapPlane(vec4 light, GnoCaster t, int facing, uint precision)          the caster's own plane; the light's side is positive
//   vec4  gnoTopPlane(vec4 light, GnoCaster t, uint place, uint flags, uint precision) whichever of the three node `place` of t's volume has; flags
//   as in node.h
//   float gnoTopSide(vec4 plane, vec3 q)                   > 0: positive side
//   float gnoTopBand(vec4 light, bool cap, float scale, float reach)       |side| <= band: the sign is not certain
//   float gnoTopMargin(vec4 light, bool cap, float scale, float reach)     |side| > margin at all three vertices: so is the whole volume
//   float gnoTopLeastDepth(vec4 light, GnoCaster t)        lower bound of gnoLightDepth over the caster, rounding included
//   float gnoTopPublishedDepth(vec4 light, GnoCaster t)    the paper's: fp32, not a bound
//   float gnoTopSpread(vec4 light, vec3 q0, vec3 q1, vec3 q2)              see gnoTopWedge
//   uint  gnoTopWedge(...)                                 upper bounds of side(q) / scale(q) and -side(q) / scale(q) over the caster's volume,
//   rounding
//                                                          included: the upper halves of their float bits, rounded up, the positive side's in the
//                                                          high half.
//                                                          `published`: the float bits of the largest sine of a vertex
//   uint  gnoTopWidest(uint a, uint b)                     the wedge that holds both (not for `published`: there it is the maximum of two uints)
//   bool  gnoTopInWedge(uint wedge, float side, float scale, uint precision)       false: certainly outside
//   uint  gnoTopPositive(...)                              bounds of side(q) / scale(q) over the volume of a caster on the positive side, from both
//   ends (9)
//   float gnoTopNegative(...)                              upper bound of -side(q) / scale(q) over the volume of a caster on the negative side
//   bool  gnoTopInPositive(uint positive, float side, float scale)                 false: certainly outside
//
// Space      positions on the scene grid; q = gnoFromLight(p); facing = gnoFacing(light, t), never 0
// Stages     any; pure
// Requires   #version 450, no extension
//
// The constants hold for the expressions as written, componentwise, without contraction. gnoTopPlane's plane has to have the same bits each time it
// is asked for (the margin of 3 is for one stored n): a plane's products that are added up are `precise`; one compiler is taken to divide and to
// draw a root alike in each of its shaders.
// u = GNO_ULP = 2^-23 bounds the relative error of one
// operation in any rounding mode, E = GNO_BAND = 8u. Grid coordinates keep every product far above the smallest normal number but for
// cross products of tiny edges: planes of length below 2^-50 count as garbage, so flushed denormals cost nothing but certainty.
//
// 1. A plane. r and e are differences of grid points (relative error u each), m = fl(cross(r, e)). A component of m errs by at most
//    (2u + u + u)(|r_y e_z| + |r_z e_y|) to first order; the vector of these sums is no longer than sqrt(2) |r||e|, so
//    |m - N| <= 5.7u |r||e| <= err = 8u |r||e|, N the exact normal. Stored is n = m / (len kappa), kappa = (err/len + E) / E, len = |m|.
// 2. Band, point light, lateral plane (passes through the light, offset 0). side = fl(n.q) errs by 3u|n||q| (products and sums), u|n||q| (q is
//    rounded), u|n||q| (n's components are rounded): 5u|q|/kappa. So |side kappa len - N.q| <= (err/len + 5u) |q| len, and if the exact sign is
//    not that of side, |side| <= (err/len + 5u)|q|/kappa < E|q|. The slack (3u, and 5.7 against 8 in err) covers len, kappa, and the band's own
//    product.
// 3. Margin, point light, lateral. All vertices have side > 3E|v|, hence exactly n.v > (3E - 5u)|v|. A point of the volume is q = sum l_i v_i, l_i
//    >= 0: n.q > (3E - 5u)|q|, its computed side > (3E - 10u)|q| = 14u|q| > E|q|: it is outside the band, on the same side.
// 4. Cap, point light. side = fl(n.q + d), d = fl(-n.a). Errors: 5u|q| + 6u reach (d's own dot product, a's rounding, the last sum), and
//    (err/len)(|q| + reach) from m: below E(|q| + reach). Only "the whole volume is behind the cap" needs a margin (a caster in the positive child
//    is visited from the band and from above): all vertices behind by more than 3E(|v| + reach) are exactly behind, the light is in front, so the
//    volume
//    - it starts at the caster and leads away from the light - is behind too.
// 5. Directional light, S = GNO_SCENE_RADIUS. side = fl(n.p + d): 5uS against the stored plane, which errs against N by (err/len + 6u) 2S/kappa:
//    band 2ES. N.D = 0, so |n.D'| <= (err/len + u)/kappa <= E for D' = D/|D|. A point of the volume is x - mu D', x in the caster, mu <= 2S: its
//    computed side is above margin - 5uS - 2SE - 5uS > 2ES when the margin is 5.25ES; taken: 6ES. The same for the cap with margin 6ES.
// 6. Wedge, for the positive side (the negative one likewise with -o_i). o_i = computed sides of the vertices. Point: w = max(0, max o_i/|v_i|), c
//    the unit sum of the vertices' directions, s = min c.v_i/|v_i|: for q = sum l_i v_i, n.q <= sum l_i max(0, n.v_i) and |q| >= c.q >= s sum l_i
//    |v_i|, so side/|q| <= (w + 10u + rounding)/s:
//    (w + 2E)/(s - 2E) (s errs by 11u), used when s > 1/64. And with depth, a lower bound of the caster's distance: the volume's directions are the
//    caster's, so (max(0, max o_i) + 2E max |v_i|)/depth. Each is valid; the smaller is taken. The paper's bound (its vertices' largest sine) is
//    not: an arc between two vertices bulges.
//    Directional: side <= max(0, max o_i) + 2SE + 10uS < max(0, max o_i) + 6ES over the volume; divided by the scale S it is comparable in the same
//    way.
//    A side in the band is below 2E and so below either bound, whatever its computed sign.
// 7. Least depth. Any vector g of length <= 1 + 4u bounds the distance from below by min g.v_i; minus 2E|v_i| (g.v errs by 4u|v|, |q| in the query
//    by 4u|q|). Directional: min over the vertices of the depth, each side errs by at most 16u, so minus 5E.
// 8. Substitute. An edge that points at the light leaves its plane undetermined: kappa = 1 + 1/sin(angle between r and e), and at err >= len nothing
//    is left of it. Any plane through the light may route, so such an edge (kappa > 64) gets one that leaves the whole caster certainly on its
//    negative side, beyond the build's own margin (it is looked at with the expressions of the build): a point of the owner's volume is then
//    certainly negative, too, and (2), (3), (5) and (6) hold for the stored plane, which errs by nothing. Inside its band a point is in no volume of
//    the owner, the positive or the negative child. It says nothing about the owner otherwise: whoever comes out behind the cap of such a volume is
//    decided exactly, all planes at once, and the volume swallows no other caster.
// 9. Bounds from both ends, for what lies wholly on one side. From above, either side: (6), which asks nothing of where the caster lies; a touching
//    vertex, whose side is taken for 0, has exactly |n.v| <= E|v| for the stored n, with the 5u of the point's own side still below the 2E of (6).
//    From below, the positive side, point light:
//    all o_i >= 0, m = min o_i/|v_i|; n.q = sum l_i n.v_i >= (m - 5u) sum l_i |v_i| >= (m - 5u)|q| where m > 5u, for |q| <= sum l_i |v_i|: an arc
//    between two vertices bulges away from the plane, so here the vertices do. The point's own side errs by 5u|q|, m itself by 6u m <= 7u: m - 2E,
//    and less by 16u of itself for the product in the query and |q|. Directional: min o_i - 6ES, as in (6). Where that is below 0 it is stored as 0,
//    and a computed side below 0 is looked up as 0: the exact sign may have sent such a point to the positive side. Both bounds are of the computed
//    side of every point of the volume, so the band needs no case of its own, nor does a substitute plane.
#ifndef GNO_TOP_PLANE_GLSL
#define GNO_TOP_PLANE_GLSL
#include "../core/light.glsl"
#include "../core/portable.h"
#include "node.h"
GNO_NAMESPACE_BEGIN

GNO_CONST float GNO_TOP_NO_BOUND = 1e30f;

// `published`: unit length. Otherwise scaled as (1) above, so that the band is GNO_BAND times the scale whatever the edge.
GNO_INLINE vec3 gnoTopNormal_(vec3 r_, vec3 e_, uint precision_) {
    vec3 m_ = gnoCross(r_, e_);
    float length_ = gnoLength(m_);
    if (precision_ == GNO_PRECISION_PUBLISHED) return length_ > 0.0f ? m_ * (1.0f / length_) : vec3(0.0f);
    float error_ = 8.0f * GNO_ULP * gnoLength(r_) * gnoLength(e_);
    if (!(error_ < length_) || length_ < 8.8817841970012523e-16f) return vec3(0.0f);  // 2^-50; everything is in the band
    float kappa_ = (error_ / length_ + GNO_BAND) / GNO_BAND;
    return m_ * (1.0f / (length_ * kappa_));
}

GNO_INLINE bool gnoTopLess_(vec3 a_, vec3 b_) {  // by x, then y, then z; -0 equals 0
    if (a_.x != b_.x) return a_.x < b_.x;
    if (a_.y != b_.y) return a_.y < b_.y;
    return a_.z < b_.z;
}

// Two triangles that share an edge get the same plane, up to its sign: its end points are taken in lexicographic order.
GNO_INLINE vec4 gnoTopLateralPlane(vec4 light_, vec3 a_, vec3 b_, int facing_, uint precision_) {
    bool swap_ = gnoTopLess_(b_, a_);
    vec3 first_ = swap_ ? b_ : a_;
    vec3 second_ = swap_ ? a_ : b_;
    precise float x_ = first_.x * light_.w - light_.x;  // from the light to the edge: first - L, or -D
    precise float y_ = first_.y * light_.w - light_.y;
    precise float z_ = first_.z * light_.w - light_.z;
    vec3 n_ = gnoTopNormal_(vec3(x_, y_, z_), second_ - first_, precision_);
    if (swap_ != (facing_ > 0)) n_ = -n_;
    float offset_ = light_.w != 0.0f ? 0.0f : -gnoDot(n_, first_);
    return vec4(n_, offset_);
}

GNO_INLINE float gnoTopSide(vec4 plane_, vec3 q_) {
    precise float side_ = plane_.x * q_.x + plane_.y * q_.y + plane_.z * q_.z + plane_.w;
    return side_;
}

GNO_INLINE float gnoTopBand(vec4 light_, bool cap_, float scale_, float reach_) {
    if (light_.w == 0.0f) return 2.0f * GNO_BAND * GNO_SCENE_RADIUS;
    return GNO_BAND * (cap_ ? scale_ + reach_ : scale_);
}

GNO_INLINE float gnoTopMargin(vec4 light_, bool cap_, float scale_, float reach_) {
    if (light_.w == 0.0f) return 6.0f * GNO_BAND * GNO_SCENE_RADIUS;
    return 3.0f * GNO_BAND * (cap_ ? scale_ + reach_ : scale_);
}

GNO_INLINE vec3 gnoTopUnit_(vec3 v_) {  // zero stays zero
    float length_ = gnoLength(v_);
    return length_ > 1e-15f ? v_ * (1.0f / length_) : vec3(0.0f);
}

// Towards the outside of the edge at `place` (0: ab, 1: bc, 2: ca), at a right angle to `axis`; where the caster is too thin to tell, one of three
// directions.
GNO_INLINE vec3 gnoTopOutward_(vec3 axis_, vec3 toThird_, uint place_) {
    precise vec3 across_ = toThird_ - axis_ * gnoDot(toThird_, axis_);
    if (gnoLength(across_) > 64.0f * GNO_BAND) return -gnoTopUnit_(across_);
    vec3 other_ = abs(axis_.x) < 0.6f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
    vec3 first_ = gnoTopUnit_(gnoCross(axis_, other_));
    vec3 second_ = gnoCross(axis_, first_);
    float turn_ = place_ == 0u ? 0.0f : place_ == 1u ? 0.8660254f : -0.8660254f;
    precise vec3 turned_ = first_ * (place_ == 0u ? 1.0f : -0.5f) + second_ * turn_;
    return gnoTopUnit_(turned_);
}

// False: the edge's own plane is good enough, or no plane of this kind was found.
GNO_INLINE bool gnoTopSubstitute(vec4 light_, GnoCaster t_, uint place_, GNO_OUT(vec4) plane_) {
    plane_ = vec4(0.0f);
    vec3 a_ = place_ == 0u ? t_.a : place_ == 1u ? t_.b : t_.c;
    vec3 b_ = place_ == 0u ? t_.b : place_ == 1u ? t_.c : t_.a;
    vec3 c_ = place_ == 0u ? t_.c : place_ == 1u ? t_.a : t_.b;
    bool point_ = light_.w != 0.0f;
    vec3 qa_ = gnoFromLight(light_, a_);
    vec3 qb_ = gnoFromLight(light_, b_);
    vec3 qc_ = gnoFromLight(light_, c_);
    vec3 r_ = point_ ? qa_ : vec3(light_.x, light_.y, light_.z);
    vec3 e_ = b_ - a_;
    if (gnoLength(gnoCross(r_, e_)) * 63.0f > gnoLength(r_) * gnoLength(e_)) return false;  // kappa <= 64
    vec3 n_;
    float offset_ = 0.0f;
    if (point_) {
        vec3 ua_ = gnoTopUnit_(qa_);
        vec3 ub_ = gnoTopUnit_(qb_);
        vec3 uc_ = gnoTopUnit_(qc_);
        vec3 axis_ = gnoTopUnit_(ua_ + ub_);
        vec3 outward_ = gnoTopOutward_(axis_, uc_, place_);
        float tilt_ = max(0.0f, max(gnoDot(outward_, ua_), max(gnoDot(outward_, ub_), gnoDot(outward_, uc_)))) + 6.0f * GNO_BAND;
        precise vec3 tilted_ = outward_ - axis_ * tilt_;
        n_ = gnoTopUnit_(tilted_) * (1.0f - GNO_BAND);
    } else {
        vec3 axis_ = gnoTopUnit_(r_);
        n_ = gnoTopOutward_(axis_, c_ - a_, place_);  // what is left of a long vector may lean towards the axis by far more than E: see (5)
        precise vec3 across_ = n_ - axis_ * gnoDot(n_, axis_);
        n_ = gnoTopUnit_(across_) * (1.0f - GNO_BAND);
        offset_ = -max(gnoDot(n_, qa_), max(gnoDot(n_, qb_), gnoDot(n_, qc_))) - 8.0f * GNO_BAND * GNO_SCENE_RADIUS;
    }
    plane_ = vec4(n_, offset_);
    return gnoTopSide(plane_, qa_) < -gnoTopMargin(light_, false, gnoLightScale(light_, qa_), 0.0f) &&
           gnoTopSide(plane_, qb_) < -gnoTopMargin(light_, false, gnoLightScale(light_, qb_), 0.0f) &&
           gnoTopSide(plane_, qc_) < -gnoTopMargin(light_, false, gnoLightScale(light_, qc_), 0.0f);
}

GNO_INLINE vec4 gnoTopCapPlane(vec4 light_, GnoCaster t_, int facing_, uint precision_) {
    vec3 n_ = gnoTopNormal_(t_.b - t_.a, t_.c - t_.a, precision_);
    if (facing_ > 0) n_ = -n_;
    return vec4(n_, -gnoDot(n_, gnoFromLight(light_, t_.a)));
}

GNO_INLINE vec4 gnoTopPlane(vec4 light_, GnoCaster t_, uint place_, uint flags_, uint precision_) {
    int facing_ = int(flags_ & 3u) - 1;
    if (place_ == 3u) return gnoTopCapPlane(light_, t_, facing_, precision_);
    if ((flags_ & (GNO_TOP_SUBSTITUTE << place_)) != 0u) {
        vec4 substitute_;
        gnoTopSubstitute(light_, t_, place_, substitute_);
        return substitute_;
    }
    vec3 a_ = place_ == 0u ? t_.a : place_ == 1u ? t_.b : t_.c;
    vec3 b_ = place_ == 0u ? t_.b : place_ == 1u ? t_.c : t_.a;
    return gnoTopLateralPlane(light_, a_, b_, facing_, precision_);
}

// The point of the triangle nearest to the origin, approximately (Ericson, Real-Time Collision Detection, 5.1.5). Any error only loosens a bound.
GNO_INLINE vec3 gnoTopNearestPoint_(vec3 a_, vec3 b_, vec3 c_) {
    vec3 ab_ = b_ - a_;
    vec3 ac_ = c_ - a_;
    float d1_ = -gnoDot(ab_, a_);
    float d2_ = -gnoDot(ac_, a_);
    if (d1_ <= 0.0f && d2_ <= 0.0f) return a_;
    float d3_ = -gnoDot(ab_, b_);
    float d4_ = -gnoDot(ac_, b_);
    if (d3_ >= 0.0f && d4_ <= d3_) return b_;
    float vc_ = d1_ * d4_ - d3_ * d2_;
    if (vc_ <= 0.0f && d1_ >= 0.0f && d3_ <= 0.0f && d1_ - d3_ > 0.0f) return a_ + ab_ * (d1_ / (d1_ - d3_));
    float d5_ = -gnoDot(ab_, c_);
    float d6_ = -gnoDot(ac_, c_);
    if (d6_ >= 0.0f && d5_ <= d6_) return c_;
    float vb_ = d5_ * d2_ - d1_ * d6_;
    if (vb_ <= 0.0f && d2_ >= 0.0f && d6_ <= 0.0f && d2_ - d6_ > 0.0f) return a_ + ac_ * (d2_ / (d2_ - d6_));
    float va_ = d3_ * d6_ - d5_ * d4_;
    float e_ = (d4_ - d3_) + (d5_ - d6_);
    if (va_ <= 0.0f && d4_ - d3_ >= 0.0f && d5_ - d6_ >= 0.0f && e_ > 0.0f) return b_ + (c_ - b_) * ((d4_ - d3_) / e_);
    float sum_ = va_ + vb_ + vc_;
    if (!(sum_ > 0.0f)) return a_;
    return a_ + ab_ * (vb_ / sum_) + ac_ * (vc_ / sum_);
}

// min over the vertices of g.v - 2E|v| for g = direction / |direction|; 0 when there is no direction.
GNO_INLINE float gnoTopDepthAlong_(vec3 direction_, vec3 a_, vec3 b_, vec3 c_) {
    float length_ = gnoLength(direction_);
    if (!(length_ > 1e-15f)) return 0.0f;
    vec3 g_ = direction_ * (1.0f / length_);
    float bound_ = gnoDot(g_, a_) - 2.0f * GNO_BAND * gnoLength(a_);
    bound_ = min(bound_, gnoDot(g_, b_) - 2.0f * GNO_BAND * gnoLength(b_));
    return min(bound_, gnoDot(g_, c_) - 2.0f * GNO_BAND * gnoLength(c_));
}

GNO_INLINE float gnoTopLeastDepth(vec4 light_, GnoCaster t_) {
    vec3 a_ = gnoFromLight(light_, t_.a);
    vec3 b_ = gnoFromLight(light_, t_.b);
    vec3 c_ = gnoFromLight(light_, t_.c);
    if (light_.w == 0.0f) {
        float least_ = min(gnoLightDepth(light_, a_), min(gnoLightDepth(light_, b_), gnoLightDepth(light_, c_)));
        return max(0.0f, least_ - 5.0f * GNO_BAND);
    }
    float bound_ = gnoTopDepthAlong_(gnoTopNearestPoint_(a_, b_, c_), a_, b_, c_);
    return max(0.0f, max(bound_, gnoTopDepthAlong_(a_ + b_ + c_, a_, b_, c_)));
}

// The distance of the nearest point as the paper has it (section 3.3): fp32, not a bound.
GNO_INLINE float gnoTopPublishedDepth(vec4 light_, GnoCaster t_) {
    vec3 a_ = gnoFromLight(light_, t_.a);
    vec3 b_ = gnoFromLight(light_, t_.b);
    vec3 c_ = gnoFromLight(light_, t_.c);
    if (light_.w == 0.0f) return min(gnoLightDepth(light_, a_), min(gnoLightDepth(light_, b_), gnoLightDepth(light_, c_)));
    return gnoLength(gnoTopNearestPoint_(a_, b_, c_));
}

// s of (6): how narrow the caster is, seen from the light; not positive when it has no use.
GNO_INLINE float gnoTopSpread(vec4 light_, vec3 q0_, vec3 q1_, vec3 q2_) {
    float l0_ = gnoLength(q0_);
    float l1_ = gnoLength(q1_);
    float l2_ = gnoLength(q2_);
    if (light_.w == 0.0f || !(min(l0_, min(l1_, l2_)) > 1e-15f)) return 0.0f;
    vec3 u0_ = q0_ * (1.0f / l0_);
    vec3 u1_ = q1_ * (1.0f / l1_);
    vec3 u2_ = q2_ * (1.0f / l2_);
    vec3 sum_ = u0_ + u1_ + u2_;
    float length_ = gnoLength(sum_);
    if (!(length_ > 0.1f)) return 0.0f;
    vec3 c_ = sum_ * (1.0f / length_);
    return min(gnoDot(c_, u0_), min(gnoDot(c_, u1_), gnoDot(c_, u2_))) - 2.0f * GNO_BAND;
}

// One bound of (6): `most` = max of side/scale over the vertices, `farthest` = max scale, `widest` = max side; both sides not below 0.
GNO_INLINE float gnoTopBound_(vec4 light_, float most_, float widest_, float farthest_, float depth_, float spread_) {
    if (light_.w == 0.0f) return (widest_ + 6.0f * GNO_BAND * GNO_SCENE_RADIUS) * ((1.0f + 4.0f * GNO_ULP) / GNO_SCENE_RADIUS);
    float bound_ = GNO_TOP_NO_BOUND;
    if (spread_ > 0.015625f) bound_ = (most_ + 2.0f * GNO_BAND) / spread_;
    if (depth_ > 1e-12f) bound_ = min(bound_, (widest_ + 2.0f * GNO_BAND * farthest_) / depth_);
    return bound_ * (1.0f + 16.0f * GNO_ULP);
}

GNO_INLINE float gnoTopMax_(vec3 v_) { return max(v_.x, max(v_.y, v_.z)); }

GNO_INLINE uint gnoTopHalf_(float bound_) { return (floatBitsToUint(bound_) + 0xFFFFu) >> 16; }  // the upper half of its bits, rounded up

GNO_INLINE uint gnoTopWidest(uint a_, uint b_) { return max(a_ & 0xFFFF0000u, b_ & 0xFFFF0000u) | max(a_ & 0xFFFFu, b_ & 0xFFFFu); }

// sides, scales: gnoTopSide and gnoLightScale of the caster's three vertices; depth = gnoTopLeastDepth, spread = gnoTopSpread.
GNO_INLINE uint gnoTopWedge(vec4 light_, vec3 sides_, vec3 scales_, float depth_, float spread_, uint precision_) {
    bool usable_ = light_.w == 0.0f || min(scales_.x, min(scales_.y, scales_.z)) > 1e-15f;
    if (precision_ == GNO_PRECISION_PUBLISHED) {  // vertices only: an arc between two of them may bulge beyond both
        if (!usable_) return floatBitsToUint(GNO_TOP_NO_BOUND);
        return floatBitsToUint(gnoTopMax_(vec3(abs(sides_.x) / scales_.x, abs(sides_.y) / scales_.y, abs(sides_.z) / scales_.z)));
    }
    if (!usable_) return (gnoTopHalf_(GNO_TOP_NO_BOUND) << 16) | gnoTopHalf_(GNO_TOP_NO_BOUND);
    vec3 sines_ = vec3(sides_.x / scales_.x, sides_.y / scales_.y, sides_.z / scales_.z);
    float farthest_ = gnoTopMax_(scales_);
    float positive_ = gnoTopBound_(light_, max(0.0f, gnoTopMax_(sines_)), max(0.0f, gnoTopMax_(sides_)), farthest_, depth_, spread_);
    float negative_ = gnoTopBound_(light_, max(0.0f, gnoTopMax_(-sines_)), max(0.0f, gnoTopMax_(-sides_)), farthest_, depth_, spread_);
    return (gnoTopHalf_(positive_) << 16) | gnoTopHalf_(negative_);
}

// False: no point of the intersection child's volumes has this side and scale.
GNO_INLINE bool gnoTopInWedge(uint wedge_, float side_, float scale_, uint precision_) {
    if (precision_ == GNO_PRECISION_PUBLISHED) return abs(side_) <= uintBitsToFloat(wedge_) * scale_;
    return side_ > 0.0f ? side_ <= uintBitsToFloat(wedge_ & 0xFFFF0000u) * scale_ : -side_ <= uintBitsToFloat(wedge_ << 16) * scale_;
}

GNO_INLINE float gnoTopMin_(vec3 v_) { return min(v_.x, min(v_.y, v_.z)); }

// Arguments as gnoTopWedge; no side below 0. High half: from above. Low half: from below, as 0xFFFF minus it, so that both halves grow and
// gnoTopWidest holds both.
GNO_INLINE uint gnoTopPositive(vec4 light_, vec3 sides_, vec3 scales_, float depth_, float spread_) {
    if (!(light_.w == 0.0f || gnoTopMin_(scales_) > 1e-15f)) return (gnoTopHalf_(GNO_TOP_NO_BOUND) << 16) | 0xFFFFu;
    vec3 sines_ = vec3(sides_.x / scales_.x, sides_.y / scales_.y, sides_.z / scales_.z);
    float most_ = gnoTopBound_(light_, max(0.0f, gnoTopMax_(sines_)), max(0.0f, gnoTopMax_(sides_)), gnoTopMax_(scales_), depth_, spread_);
    float least_ =
        light_.w == 0.0f ? (gnoTopMin_(sides_) - 6.0f * GNO_BAND * GNO_SCENE_RADIUS) / GNO_SCENE_RADIUS : gnoTopMin_(sines_) - 2.0f * GNO_BAND;
    least_ = max(0.0f, least_ * (1.0f - 16.0f * GNO_ULP));
    return (gnoTopHalf_(most_) << 16) | (0xFFFFu - (floatBitsToUint(least_) >> 16));
}

GNO_INLINE float gnoTopNegative(vec4 light_, vec3 sides_, vec3 scales_, float depth_, float spread_) {
    if (!(light_.w == 0.0f || gnoTopMin_(scales_) > 1e-15f)) return GNO_TOP_NO_BOUND;
    vec3 sines_ = vec3(sides_.x / scales_.x, sides_.y / scales_.y, sides_.z / scales_.z);
    return gnoTopBound_(light_, max(0.0f, -gnoTopMin_(sines_)), max(0.0f, -gnoTopMin_(sides_)), gnoTopMax_(scales_), depth_, spread_);
}

GNO_INLINE bool gnoTopInPositive(uint positive_, float side_, float scale_) {
    float from_ = max(side_, 0.0f);
    return from_ <= uintBitsToFloat(positive_ & 0xFFFF0000u) * scale_ && from_ >= uintBitsToFloat((0xFFFFu - (positive_ & 0xFFFFu)) << 16) * scale_;
}

GNO_NAMESPACE_END
#endif
