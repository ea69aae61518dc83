// SPDX-License-Identifier: MIT
// gnomon forest/cells.glsl : which cell of the light's grid a view sample lies in, and which cells a caster's shadow volume may meet.
//
//   vec3  gnoCellPlace(vec4 light, GnoForestGrid grid, uint face, vec3 q)      on a face: x and y over z, z > 0 in front of it; directional: z = 1
//   uvec3 gnoCellAt(vec4 light, GnoForestGrid grid, vec3 q)                    the cell of a point: column, row, face
//   uint  gnoCellOf(vec4 light, GnoForestGrid grid, vec3 q)                    its index; resolution up to 16384
//   GnoCellVolume gnoCellVolume(vec4 light, GnoCaster t, int facing)           what the functions below want to know of a caster
//   GnoCellVolume gnoCellSight(vec4 light, GnoCaster t)                        the same without planes, for gnoCellRectangle alone: cheaper
//   uvec4 gnoCellRectangle(vec4 light, GnoForestGrid grid, uint face, GnoCellVolume v)           columns x .. z-1, rows y .. w-1: no other cell of
//   the face can be met
//   bool  gnoCellMissed(vec4 light, GnoForestGrid grid, uint face, uvec2 at, GnoCellVolume v)    true: the shadow volume certainly meets no point of
//   the cell
//   uint  gnoForestRoot(GnoForestCell cell, float depth)                       root of the tree to ask for a point of the cell at that
//   gnoLightDepth, or GNO_TOP_IN_SHADOW (5)
//   bool  gnoCellCovered(vec4 light, GnoForestGrid grid, uint face, uvec2 at, GnoCellVolume v)   true: see 5
//
// Space      light coordinates, q = gnoFromLight(p); facing = gnoFacing(light, t), never 0
// Stages     any; pure
// Requires   #version 450, no extension
// Source     this project; margins derived below
//
// u = GNO_ULP = 2^-23 bounds the relative error of one operation, 2.5u that of a division; E = GNO_BAND = 8u.
//
// 1. A point's cell. Point light: q is rounded, so x and z err by u each, x/z by 5u in all where |x| <= |z|, and the face is chosen by the computed
//    q. Subtracting -1 errs by 2u, the division by the step by 5u, in units of x/z: a point of cell i has exactly x/z in [bound(i) - 2E, bound(i+1)
//    + 2E], also where the index was clamped.
//    Directional: x = U.p errs by 4uS (S = GNO_SCENE_RADIUS), the subtraction by 2uS, the division by 5uS: less than 2ES in all. The
//    cells at the border hold what lies beyond it, too: casters and samples alike are clamped into them, and their corners lie at -2 and 2, farther
//    than any sample.
//    None of these errors depends on the resolution: they are counted in x/z, not in cells. Up to 65536 cells an index is exact in fp32 and fits 16
//    bits.
// 2. A cell's pyramid (prism). Its corners are taken at bound - 6E and bound + 6E (directional: 6ES), rounded: it holds every point of the cell.
// 3. Rectangle. Where z > 0 at all three vertices (a difference of two numbers has the exact sign) the volume has exactly x/z between the vertices'
//    least and greatest, whose computed values err by 5u of themselves. If the volume meets cell i, the least is below bound(i+1) + 2E, computed
//    below bound(i+1) + 3E; it is looked up 6E lower, which covers the 9u of the look-up. Directional: x errs by 4uS, and a point of the volume is v
//    - mu D', mu <= 2S, D' the light's direction, at a right angle to the axis but for 2u: 8uS, with 1. and the look-up 33uS, and 6ES are taken.
//    Where z <= 0 at all three vertices the volume has no point with z > 0, and no cell. Where z <= 0 at one or two, let m be the least x/z of the
//    others. If x - m z > 0 at the vertices with z <= 0, too, then x - m z >= 0 in the whole volume (a sum of the vertices with weights >= 0), so m
//    bounds x/z wherever z > 0; the greatest likewise. The computed x - m z errs by 2u|x| + 8u|m z|, m's own 5u included, so it has to be above
//    2E(|x| + |m z|). Otherwise the axis is not bounded on that side.
// 4. Missed. A lateral plane is held against the corners as it is against a caster in a tree (top/plane.glsl, 3 and 5): all four on the positive
//    side by the margin there, so is every point of the pyramid (prism), and the caster's volume is on the other side. This holds for a substitute
//    plane as well. One corner has the least side, by the signs of the normal's components; the others' exact sides are not less. Point: corners are
//    at z = 1, shorter than 1.8, so 3E|v| < 6E. Directional: the normal in the grid's axes errs by 4u each, times at most 2S, so 16uS more than 6ES,
//    and as much when a sign near zero is wrong: 10ES.
// 5. Covered. All four corners on the negative side of all three lateral planes by that margin, none of them a substitute (it does not bound the
//    caster): each direction of the cell passes through the open caster. A view sample of the cell is then behind the caster, in its shadow; or it
//    is in front of it or on it, and no farther from the light than `most`. A caster that starts beyond `most` decides neither, as long as the
//    covering one stays in the cell. A sample whose computed depth is beyond `most` is strictly behind the covering caster and not on it:
//    in its shadow. (A sample that lies on the covering
//    caster is on the light's side of it: gnoMakeViewSample.)
#ifndef GNO_FOREST_CELLS_GLSL
#define GNO_FOREST_CELLS_GLSL
#include "../top/plane.glsl"
#include "cells.h"
GNO_NAMESPACE_BEGIN

// Face f looks along axis f/2, even f to its positive end. Only the order and the sign of coordinates change: nothing is rounded.
GNO_INLINE vec3 gnoCellPlace(vec4 light_, GnoForestGrid grid_, uint face_, vec3 q_) {
    if (light_.w == 0.0f) return vec3(gnoDot(vec3(grid_.across), q_), gnoDot(vec3(grid_.along), q_), 1.0f);
    vec3 turned_ = face_ < 2u ? vec3(q_.y, q_.z, q_.x) : face_ < 4u ? vec3(q_.z, q_.x, q_.y) : q_;
    return (face_ & 1u) == 0u ? turned_ : vec3(turned_.x, turned_.y, -turned_.z);
}

GNO_INLINE uint gnoCellIndex_(float place_, float least_, float step_, uint resolution_) {
    float at_ = (place_ - least_) / step_;
    if (!(at_ > 0.0f)) return 0u;  // not a number: the point is the light
    return uint(min(at_, float(resolution_ - 1u)));
}

GNO_INLINE uvec3 gnoCellAt(vec4 light_, GnoForestGrid grid_, vec3 q_) {
    vec3 far_ = abs(q_);
    uint face_ = 0u;
    if (light_.w != 0.0f) {
        face_ = far_.x >= far_.y && far_.x >= far_.z ? (q_.x < 0.0f ? 1u : 0u)
                : far_.y >= far_.z                   ? (q_.y < 0.0f ? 3u : 2u)
                                                     : (q_.z < 0.0f ? 5u : 4u);
    }
    vec3 place_ = gnoCellPlace(light_, grid_, face_, q_);
    uint x_ = gnoCellIndex_(place_.x / place_.z, grid_.across.w, grid_.stepAcross, grid_.resolution);
    uint y_ = gnoCellIndex_(place_.y / place_.z, grid_.along.w, grid_.stepAlong, grid_.resolution);
    return uvec3(x_, y_, face_);
}

GNO_INLINE uint gnoCellOf(vec4 light_, GnoForestGrid grid_, vec3 q_) {
    uvec3 at_ = gnoCellAt(light_, grid_, q_);
    return (at_.z * grid_.resolution + at_.y) * grid_.resolution + at_.x;
}

GNO_INLINE float gnoCellSlack_(vec4 light_) { return light_.w == 0.0f ? 6.0f * GNO_BAND * GNO_SCENE_RADIUS : 6.0f * GNO_BAND; }

struct GnoCellVolume {
    vec3 q0;      // the vertices, seen from the light
    vec3 q1;
    vec3 q2;
    vec4 ab;      // lateral planes, as in a tree; inside is negative
    vec4 bc;
    vec4 ca;
    float least;  // lower bound of gnoLightDepth over the caster
    float most;   // upper bound of it
    bool bounded; // none of the planes is a substitute
    uint face;    // the volume meets cells of no other faces than face .. faceEnd - 1
    uint faceEnd;
};

// 6. One face. Where the same coordinate is the largest of all three vertices by more than 16E of itself, so it is of each point of the volume by
//    more than 15E, whose computed coordinates err by u: its cell is on that face.
GNO_INLINE bool gnoCellAllUnder_(vec3 far_, vec3 other_, vec3 another_) {
    vec3 most_ = far_ * (1.0f - 16.0f * GNO_BAND);
    return abs(other_.x) < most_.x && abs(another_.x) < most_.x && abs(other_.y) < most_.y && abs(another_.y) < most_.y && abs(other_.z) < most_.z &&
           abs(another_.z) < most_.z;
}

GNO_INLINE GnoCellVolume gnoCellSight(vec4 light_, GnoCaster t_) {
    GnoCellVolume v_;
    v_.q0 = gnoFromLight(light_, t_.a);
    v_.q1 = gnoFromLight(light_, t_.b);
    v_.q2 = gnoFromLight(light_, t_.c);
    v_.ab = vec4(0.0f);
    v_.bc = vec4(0.0f);
    v_.ca = vec4(0.0f);
    v_.bounded = false;
    v_.least = gnoTopLeastDepth(light_, t_);
    float most_ = max(gnoLightDepth(light_, v_.q0), max(gnoLightDepth(light_, v_.q1), gnoLightDepth(light_, v_.q2)));
    v_.most = light_.w == 0.0f ? most_ + 5.0f * GNO_BAND : most_ * (1.0f + 2.0f * GNO_BAND);  // a point's own depth errs by 4u, directional by 16u
    vec3 x_ = vec3(v_.q0.x, v_.q1.x, v_.q2.x);
    vec3 y_ = vec3(v_.q0.y, v_.q1.y, v_.q2.y);
    vec3 z_ = vec3(v_.q0.z, v_.q1.z, v_.q2.z);
    uint face_ = 6u;
    if (gnoCellAllUnder_(x_, y_, z_)) face_ = 0u;
    if (gnoCellAllUnder_(-x_, y_, z_)) face_ = 1u;
    if (gnoCellAllUnder_(y_, x_, z_)) face_ = 2u;
    if (gnoCellAllUnder_(-y_, x_, z_)) face_ = 3u;
    if (gnoCellAllUnder_(z_, x_, y_)) face_ = 4u;
    if (gnoCellAllUnder_(-z_, x_, y_)) face_ = 5u;
    bool one_ = light_.w == 0.0f || face_ < 6u;
    v_.face = light_.w == 0.0f || face_ == 6u ? 0u : face_;
    v_.faceEnd = one_ ? v_.face + 1u : 6u;
    return v_;
}

GNO_INLINE GnoCellVolume gnoCellVolume(vec4 light_, GnoCaster t_, int facing_) {
    GnoCellVolume v_ = gnoCellSight(light_, t_);
    bool substituted_ = false;
    if (gnoTopSubstitute(light_, t_, 0u, v_.ab)) substituted_ = true;
    else v_.ab = gnoTopLateralPlane(light_, t_.a, t_.b, facing_, GNO_PRECISION_CERTIFIED);
    if (gnoTopSubstitute(light_, t_, 1u, v_.bc)) substituted_ = true;
    else v_.bc = gnoTopLateralPlane(light_, t_.b, t_.c, facing_, GNO_PRECISION_CERTIFIED);
    if (gnoTopSubstitute(light_, t_, 2u, v_.ca)) substituted_ = true;
    else v_.ca = gnoTopLateralPlane(light_, t_.c, t_.a, facing_, GNO_PRECISION_CERTIFIED);
    v_.bounded = !substituted_;
    return v_;
}

// Columns (or rows) from `least` to `greatest` on an axis; x >= y: none.
GNO_INLINE uvec2 gnoCellRange_(vec4 light_, float least_, float greatest_, float axisLeast_, float step_, uint resolution_) {
    float last_ = float(resolution_ - 1u);
    float slack_ = gnoCellSlack_(light_);
    float from_ = (least_ - slack_ - axisLeast_) / step_;
    float to_ = (greatest_ + slack_ - axisLeast_) / step_;
    if (light_.w != 0.0f && (from_ >= last_ + 1.0f || to_ < 0.0f)) return uvec2(0u, 0u);
    return uvec2(uint(min(max(from_, 0.0f), last_)), uint(min(max(to_, 0.0f), last_)) + 1u);
}

// The greatest x/z of a volume with these vertices, where z > 0 (one of them has z > 0).
GNO_INLINE float gnoCellGreatest_(vec3 x_, vec3 z_) {
    float a_ = z_.x > 0.0f ? x_.x / z_.x : -GNO_TOP_NO_BOUND;
    float b_ = z_.y > 0.0f ? x_.y / z_.y : -GNO_TOP_NO_BOUND;
    float c_ = z_.z > 0.0f ? x_.z / z_.z : -GNO_TOP_NO_BOUND;
    float most_ = max(a_, max(b_, c_));
    bool bounded_ = (z_.x > 0.0f || most_ * z_.x - x_.x > 2.0f * GNO_BAND * (abs(x_.x) + abs(most_ * z_.x))) &&
                    (z_.y > 0.0f || most_ * z_.y - x_.y > 2.0f * GNO_BAND * (abs(x_.y) + abs(most_ * z_.y))) &&
                    (z_.z > 0.0f || most_ * z_.z - x_.z > 2.0f * GNO_BAND * (abs(x_.z) + abs(most_ * z_.z)));
    return bounded_ ? most_ : GNO_TOP_NO_BOUND;
}

GNO_INLINE uvec4 gnoCellRectangle(vec4 light_, GnoForestGrid grid_, uint face_, GnoCellVolume v_) {
    vec3 a_ = gnoCellPlace(light_, grid_, face_, v_.q0);
    vec3 b_ = gnoCellPlace(light_, grid_, face_, v_.q1);
    vec3 c_ = gnoCellPlace(light_, grid_, face_, v_.q2);
    vec3 depth_ = vec3(a_.z, b_.z, c_.z);
    if (!(gnoTopMax_(depth_) > 0.0f)) return uvec4(0u, 0u, 0u, 0u);
    vec3 x_ = vec3(a_.x, b_.x, c_.x);
    vec3 y_ = vec3(a_.y, b_.y, c_.y);
    uvec2 columns_ =
        gnoCellRange_(light_, -gnoCellGreatest_(-x_, depth_), gnoCellGreatest_(x_, depth_), grid_.across.w, grid_.stepAcross, grid_.resolution);
    uvec2 rows_ =
        gnoCellRange_(light_, -gnoCellGreatest_(-y_, depth_), gnoCellGreatest_(y_, depth_), grid_.along.w, grid_.stepAlong, grid_.resolution);
    if (columns_.x >= columns_.y || rows_.x >= rows_.y) return uvec4(0u, 0u, 0u, 0u);
    return uvec4(columns_.x, rows_.x, columns_.y, rows_.y);
}

// Lower or upper bound of a row or column.
GNO_INLINE float gnoCellBound_(vec4 light_, float axisLeast_, float step_, uint resolution_, uint at_, bool upper_) {
    if (light_.w == 0.0f && !upper_ && at_ == 0u) return -2.0f;
    if (light_.w == 0.0f && upper_ && at_ + 1u == resolution_) return 2.0f;
    float slack_ = gnoCellSlack_(light_);
    return axisLeast_ + float(upper_ ? at_ + 1u : at_) * step_ + (upper_ ? slack_ : -slack_);
}

// The least of sign * side over a cell's pyramid at z = 1 (prism), from the corner where it is.
GNO_INLINE float gnoCellLeastSide_(vec4 light_, GnoForestGrid grid_, uint face_, uvec2 at_, vec4 plane_, float sign_) {
    vec3 n_ = vec3(plane_.x, plane_.y, plane_.z) * sign_;
    vec3 m_ = gnoCellPlace(light_, grid_, face_, n_);
    float offset_ = light_.w == 0.0f ? plane_.w * sign_ : m_.z;
    float x_ = gnoCellBound_(light_, grid_.across.w, grid_.stepAcross, grid_.resolution, at_.x, m_.x < 0.0f);
    float y_ = gnoCellBound_(light_, grid_.along.w, grid_.stepAlong, grid_.resolution, at_.y, m_.y < 0.0f);
    precise float side_ = m_.x * x_ + m_.y * y_ + offset_;
    return side_;
}

GNO_INLINE float gnoCellMargin_(vec4 light_) { return light_.w == 0.0f ? 10.0f * GNO_BAND * GNO_SCENE_RADIUS : 6.0f * GNO_BAND; }

GNO_INLINE bool gnoCellMissed(vec4 light_, GnoForestGrid grid_, uint face_, uvec2 at_, GnoCellVolume v_) {
    float margin_ = gnoCellMargin_(light_);
    return gnoCellLeastSide_(light_, grid_, face_, at_, v_.ab, 1.0f) > margin_ ||
           gnoCellLeastSide_(light_, grid_, face_, at_, v_.bc, 1.0f) > margin_ ||
           gnoCellLeastSide_(light_, grid_, face_, at_, v_.ca, 1.0f) > margin_;
}

GNO_INLINE bool gnoCellCovered(vec4 light_, GnoForestGrid grid_, uint face_, uvec2 at_, GnoCellVolume v_) {
    if (!v_.bounded) return false;
    float margin_ = gnoCellMargin_(light_);
    return gnoCellLeastSide_(light_, grid_, face_, at_, v_.ab, -1.0f) > margin_ &&
           gnoCellLeastSide_(light_, grid_, face_, at_, v_.bc, -1.0f) > margin_ &&
           gnoCellLeastSide_(light_, grid_, face_, at_, v_.ca, -1.0f) > margin_;
}

GNO_INLINE uint gnoForestRoot(GnoForestCell cell_, float depth_) { return floatBitsToUint(depth_) > cell_.cover ? GNO_TOP_IN_SHADOW : cell_.root; }

GNO_NAMESPACE_END
#endif
