// SPDX-License-Identifier: MIT
// gnomon core/decide.glsl : the last word on one caster and one point, on the rungs that have one.
//
//   bool gnoDecideInShadow(vec4 light, GnoCaster t, vec3 p, uint precision)   true: p is in the shadow volume of t
//
// certified      exactly the definition (README "What in shadow means"), core/orient3d.glsl
// conservative   the same signs in fp32, at coordinates relative to the caster's own vertices. An edge is taken with its end points in lexicographic
//                order, so that two triangles that share it agree and no point slips between them
//
// Space      all positions on the scene grid; light homogeneous (core/light.glsl)
// Stages     any; pure
// Requires   #version 450, no extension
#ifndef GNO_CORE_DECIDE_GLSL
#define GNO_CORE_DECIDE_GLSL
#include "light.glsl"
#include "orient3d.glsl"
GNO_NAMESPACE_BEGIN

// orient3d(light, a, b, p) in fp32, up to a positive factor.
GNO_INLINE float gnoEdgeSide_(vec4 light_, vec3 a_, vec3 b_, vec3 p_) {
    bool swap_ = a_.x != b_.x ? b_.x < a_.x : a_.y != b_.y ? b_.y < a_.y : b_.z < a_.z;
    vec3 first_ = swap_ ? b_ : a_;
    vec3 second_ = swap_ ? a_ : b_;
    precise float x_ = first_.x * light_.w - light_.x;
    precise float y_ = first_.y * light_.w - light_.y;
    precise float z_ = first_.z * light_.w - light_.z;
    float side_ = gnoDot(gnoCross(vec3(x_, y_, z_), second_ - first_), p_ - first_);
    return swap_ ? -side_ : side_;
}

GNO_INLINE bool gnoDecideInShadow(vec4 light_, GnoCaster t_, vec3 p_, uint precision_) {
    if (precision_ == GNO_PRECISION_CERTIFIED) return gnoInShadowOf(light_, t_, p_);
    vec3 normal_ = gnoCross(t_.b - t_.a, t_.c - t_.a);
    precise float x_ = light_.x - t_.a.x * light_.w;
    precise float y_ = light_.y - t_.a.y * light_.w;
    precise float z_ = light_.z - t_.a.z * light_.w;
    float front_ = gnoDot(normal_, vec3(x_, y_, z_));  // orient3d(a, b, c, light) = -orient3d(light, a, b, c)
    float side_ = gnoDot(normal_, p_ - t_.a);
    if (front_ == 0.0f || side_ == 0.0f || (front_ > 0.0f) == (side_ > 0.0f)) return false;
    float sign_ = front_ > 0.0f ? -1.0f : 1.0f;
    if (gnoEdgeSide_(light_, t_.a, t_.b, p_) * sign_ < 0.0f) return false;
    if (gnoEdgeSide_(light_, t_.b, t_.c, p_) * sign_ < 0.0f) return false;
    return gnoEdgeSide_(light_, t_.c, t_.a, p_) * sign_ >= 0.0f;
}

GNO_NAMESPACE_END
#endif
