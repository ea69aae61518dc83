// SPDX-License-Identifier: MIT
// gnomon core/sample_from_depth.glsl : view samples for an engine that keeps depth and normal, but not which primitive it drew.
//
//   vec3  gnoPositionFromDepth(mat4 gridFromClip, vec2 ndc, float depth)      where a texel of the depth buffer lies
//   float gnoDepthError(mat4 gridFromClip, vec2 ndc, float depth, vec3 n, float depthStep, vec2 snap)
//        bound of the distance between that position and the plane of the caster that was drawn; n: unit normal, depthStep and snap as below
//   GnoViewSample gnoMakeViewSampleFromNormal(vec3 p, vec3 n, float error, vec4 viewer, vec4 light)
//        own = GNO_FACING_AWAY when the normal, turned to the viewer, does not face the light; else GNO_NO_CASTER
//
// Without an id nobody can skip a sample's own caster, and it need not be skipped: it shadows what lies strictly behind it, and the sample is moved
// in front of it. Let P be the point on the caster, p the position that is known, e >= |(P - p) . N| with the caster's unit normal N, and n any unit
// normal within 60 degrees of N on the lit side: a G-buffer's, quantised or interpolated. The sample is p + s n with s = 2e + 8 ulp of p + 2^-40, so
// it lies at least s/2 - e > 0 in front of the caster, rounding to the grid included. What differs from core/sample.glsl is the place alone: up to
// s + e beside the one with an id. That is the definition: a sample is in shadow when the volume of some caster, its own included, holds p + s n.
// Every technique and every rung can be asked, `own` costs nothing, and no node more is visited; an own caster whose band (top/plane.glsl, 4) is
// wider than s/2 - e is decided exactly, where with an id it would be passed.
//
// The error of a depth buffer: depthStep bounds what a depth value is off by (half a unit of its format, the rasteriser's interpolation, the vertex
// shader's rounding): GNO_DEPTH_STEP_D32 or _D24. snap is how far the rasteriser moves a vertex, in normalised device coordinates: 1 / size in
// pixels times 2^-b with b = subPixelPrecisionBits (8: lavapipe, most desktops; at least 4). gnoDepthError takes both through the projection, as far
// as they lie across n, and adds the rounding of gridFromClip in fp32 (the inverse, made in double).
//
// Space      p, viewer and light on the scene grid (viewer and light homogeneous); ndc in [-1, 1], y down; any projection, reversed or not
// Stages     any; pure
// Requires   #version 450, no extension
#ifndef GNO_CORE_SAMPLE_FROM_DEPTH_GLSL
#define GNO_CORE_SAMPLE_FROM_DEPTH_GLSL
#include "sample.glsl"
GNO_NAMESPACE_BEGIN

GNO_CONST float GNO_DEPTH_STEP_D32 = 4.76837158203125e-7f;   // 2^-21: 4 ulp of 1 interpolate, transform and store
GNO_CONST float GNO_DEPTH_STEP_D24 = 5.364418029785156e-7f;  // 2^-21 + 2^-24

GNO_INLINE vec3 gnoPositionFromDepth(mat4 gridFromClip_, vec2 ndc_, float depth_) {
    vec4 h_ = gridFromClip_ * vec4(ndc_, depth_, 1.0f);
    return vec3(h_.x / h_.w, h_.y / h_.w, h_.z / h_.w);
}

GNO_INLINE float gnoDepthError(mat4 gridFromClip_, vec2 ndc_, float depth_, vec3 n_, float depthStep_, vec2 snap_) {
    vec3 p_ = gnoPositionFromDepth(gridFromClip_, ndc_, depth_);
    vec3 nearer_ = gnoPositionFromDepth(gridFromClip_, ndc_, depth_ + depthStep_) - p_;
    vec3 right_ = gnoPositionFromDepth(gridFromClip_, ndc_ + vec2(snap_.x, 0.0f), depth_) - p_;
    vec3 down_ = gnoPositionFromDepth(gridFromClip_, ndc_ + vec2(0.0f, snap_.y), depth_) - p_;
    mat4 magnitude_ = mat4(abs(gridFromClip_[0]), abs(gridFromClip_[1]), abs(gridFromClip_[2]), abs(gridFromClip_[3]));
    vec4 sums_ = magnitude_ * vec4(abs(ndc_), abs(depth_), 1.0f);
    float w_ = abs((gridFromClip_ * vec4(ndc_, depth_, 1.0f)).w);
    float size_ = max(abs(p_.x), max(abs(p_.y), abs(p_.z)));
    float rounding_ = 4.0f * GNO_ULP * (max(sums_.x, max(sums_.y, sums_.z)) + size_ * sums_.w) / w_;
    return 2.0f * abs(gnoDot(n_, nearer_)) + abs(gnoDot(n_, right_)) + abs(gnoDot(n_, down_)) + rounding_;  // twice: farther steps are longer
}

GNO_INLINE GnoViewSample gnoMakeViewSampleFromNormal(vec3 p_, vec3 n_, float error_, vec4 viewer_, vec4 light_) {
    GnoViewSample sample_;
    sample_.position = p_;
    sample_.own = GNO_FACING_AWAY;
    float length_ = gnoLength(n_);
    if (length_ == 0.0f) return sample_;
    vec3 unit_ = n_ * (1.0f / length_);
    vec3 toViewer_ = vec3(viewer_.x, viewer_.y, viewer_.z) - p_ * viewer_.w;
    if (gnoDot(unit_, toViewer_) < 0.0f) unit_ = -unit_;
    vec3 toLight_ = vec3(light_.x, light_.y, light_.z) - p_ * light_.w;
    if (!(gnoDot(unit_, toLight_) > 0.0f)) return sample_;
    float size_ = max(abs(p_.x), max(abs(p_.y), abs(p_.z)));
    float step_ = 2.0f * error_ + 8.0f * GNO_ULP * size_ + 9.094947017729282e-13f;
    sample_.position = gnoSnapToGrid(p_ + unit_ * step_);
    sample_.own = GNO_NO_CASTER;
    return sample_;
}

GNO_NAMESPACE_END
#endif
