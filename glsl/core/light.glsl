// SPDX-License-Identifier: MIT
// gnomon core/light.glsl : one formula for a light at a point and a light at infinity.
//
// A light is homogeneous, vec4: xyz a grid position and w = 1, or xyz a direction TOWARDS the light (its own power-of-two grid: largest
// component in [0.5, 1], multiples of 2^-40) and w = 0.
//
//   vec3  gnoFromLight(vec4 light, vec3 p)    w = 1: p - light; w = 0: p. The coordinates in which planes are stored and evaluated
//   float gnoLightScale(vec4 light, vec3 q)   what rounding errors at q = gnoFromLight(p) are relative to: |q|, or the scene's radius
//   float gnoLightDepth(vec4 light, vec3 q)   grows away from the light, never negative: |q|, or the depth along the light's direction
//   float gnoDot(vec3 a, vec3 b)              dot, cross and length whose products and sums are spelled out: `precise` does not reach
//   vec3  gnoCross(vec3 a, vec3 b)            into the built-in ones
//   float gnoLength(vec3 v)
//
// Space      p on the scene grid; q = gnoFromLight(light, p)
// Rounding   GNO_ULP bounds the relative error of one fp32 operation under any rounding mode; GNO_BAND = 8 GNO_ULP is the band of
//            exactness.md, section 3: inside it a plane's sign is not certain. top/plane.glsl derives it.
// Stages     any; pure
// Requires   #version 450, no extension
#ifndef GNO_CORE_LIGHT_GLSL
#define GNO_CORE_LIGHT_GLSL
#include "shared_types.h"
GNO_NAMESPACE_BEGIN

GNO_CONST float GNO_ULP = 1.1920928955078125e-7f;   // 2^-23
GNO_CONST float GNO_BAND = 9.5367431640625e-7f;     // 2^-20
GNO_CONST float GNO_SCENE_RADIUS = 1.75f;           // sqrt(3) and some: casters and samples lie in [-1, 1] or within 2^-10 of it

GNO_INLINE vec3 gnoFromLight(vec4 light_, vec3 p_) {
    precise float x_ = p_.x - light_.x * light_.w;
    precise float y_ = p_.y - light_.y * light_.w;
    precise float z_ = p_.z - light_.z * light_.w;
    return vec3(x_, y_, z_);
}

GNO_INLINE float gnoDot(vec3 a_, vec3 b_) {  // `precise` does not reach into dot(): spell the products out
    precise float dot_ = a_.x * b_.x + a_.y * b_.y + a_.z * b_.z;
    return dot_;
}

GNO_INLINE vec3 gnoCross(vec3 a_, vec3 b_) {
    precise float x_ = a_.y * b_.z - a_.z * b_.y;
    precise float y_ = a_.z * b_.x - a_.x * b_.z;
    precise float z_ = a_.x * b_.y - a_.y * b_.x;
    return vec3(x_, y_, z_);
}

GNO_INLINE float gnoLength(vec3 v_) { return sqrt(gnoDot(v_, v_)); }

GNO_INLINE float gnoLightScale(vec4 light_, vec3 q_) { return light_.w == 0.0f ? GNO_SCENE_RADIUS : gnoLength(q_); }

// Towards infinity the depth is -D.q, shifted by 4 > 1.75 |D| so that it is never negative (and may be compared as an unsigned integer).
GNO_INLINE float gnoLightDepth(vec4 light_, vec3 q_) {
    if (light_.w != 0.0f) return gnoLength(q_);
    precise float depth_ = 4.0f - gnoDot(vec3(light_.x, light_.y, light_.z), q_);
    return depth_;
}

GNO_NAMESPACE_END
#endif
