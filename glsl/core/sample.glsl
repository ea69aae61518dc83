// SPDX-License-Identifier: MIT
// gnomon core/sample.glsl : from a rasterised position to a view sample that its own caster cannot darken.
//
//   vec3 gnoSnapToGrid(vec3 p)                          to multiples of 2^-40; what an engine does once to every position it hands to the modules
//   vec3 gnoTurnedNormal(GnoCaster t, vec3 p, vec4 viewer)        unit geometric normal, turned to the viewer; zero for a collinear caster
//   GnoViewSample gnoMakeViewSample(vec3 p, uint own, GnoCaster t, vec4 viewer, vec4 light)
//        own = GNO_FACING_AWAY when the turned normal does not face the light (exact sign; a light in the plane counts as away)
//   uvec4 gnoPackViewSample(GnoViewSample s)            one texel of an rgba32ui image: position bits, own
//   GnoViewSample gnoUnpackViewSample(uvec4 texel)
//
// A rasterised position is off its own plane by rounding: up to 0.4 ulp of the largest coordinate M of the primitive's vertices was measured. It is
// moved along the exact geometric normal (core/orient3d.glsl; slivers included) by 8 ulp of M plus 2^-40, rounded to the grid, and the exact sign of
// its own plane is looked at: if that is not the viewer's side yet the step is doubled, so the result is certain whatever the rasteriser does. There
// is no bias to tune.
//
// Space      p, t, viewer and light on the scene grid; viewer and light homogeneous: position and w = 1, or direction towards it and w = 0
// Stages     any; pure
// Requires   #version 450, no extension
#ifndef GNO_CORE_SAMPLE_GLSL
#define GNO_CORE_SAMPLE_GLSL
#include "light.glsl"
#include "orient3d.glsl"
GNO_NAMESPACE_BEGIN

GNO_INLINE float gnoSnapCoordinate_(float x_) {
    if (!(abs(x_) < 7.62939453125e-6f)) return x_;  // from 2^-17 on every fp32 number is a multiple of 2^-40
    precise float scaled_ = x_ * 1099511627776.0f;  // 2^40; both products are exact
    precise float snapped_ = roundEven(scaled_) * 9.094947017729282e-13f;
    return snapped_ == 0.0f ? 0.0f : snapped_;  // no -0
}

GNO_INLINE vec3 gnoSnapToGrid(vec3 p_) { return vec3(gnoSnapCoordinate_(p_.x), gnoSnapCoordinate_(p_.y), gnoSnapCoordinate_(p_.z)); }

GNO_INLINE vec3 gnoTurnedNormal(GnoCaster t_, vec3 p_, vec4 viewer_) {
    vec3 n_ = gnoExactNormal(t_);
    float length_ = gnoLength(n_);
    if (length_ == 0.0f) return vec3(0.0f);
    vec3 unit_ = n_ * (1.0f / length_);
    vec3 toViewer_ = vec3(viewer_.x, viewer_.y, viewer_.z) - p_ * viewer_.w;
    return gnoDot(unit_, toViewer_) < 0.0f ? -unit_ : unit_;
}

GNO_INLINE GnoViewSample gnoMakeViewSample(vec3 p_, uint own_, GnoCaster t_, vec4 viewer_, vec4 light_) {
    GnoViewSample sample_;
    sample_.position = p_;
    sample_.own = GNO_FACING_AWAY;
    vec3 n_ = gnoExactNormal(t_);
    float length_ = gnoLength(n_);
    if (length_ == 0.0f) return sample_;
    vec3 unit_ = n_ * (1.0f / length_);
    vec3 toViewer_ = vec3(viewer_.x, viewer_.y, viewer_.z) - p_ * viewer_.w;
    int side_ = gnoDot(unit_, toViewer_) < 0.0f ? -1 : 1;
    if (gnoFacing(light_, t_) != -side_) return sample_;  // orient3d(a, b, c, light) = -facing
    vec3 extent_ = max(abs(t_.a), max(abs(t_.b), abs(t_.c)));
    float step_ = 8.0f * GNO_ULP * max(extent_.x, max(extent_.y, extent_.z)) + 9.094947017729282e-13f;
    for (int i_ = 0; i_ < 20; ++i_) {
        vec3 moved_ = gnoSnapToGrid(p_ + unit_ * (float(side_) * step_));
        if (gnoOrient3d(t_.a, t_.b, t_.c, moved_) == side_) {
            sample_.position = moved_;
            sample_.own = own_;
            return sample_;
        }
        step_ *= 2.0f;
    }
    return sample_;
}

GNO_INLINE uvec4 gnoPackViewSample(GnoViewSample s_) {
    return uvec4(floatBitsToUint(s_.position.x), floatBitsToUint(s_.position.y), floatBitsToUint(s_.position.z), s_.own);
}

GNO_INLINE GnoViewSample gnoUnpackViewSample(uvec4 texel_) {
    GnoViewSample sample_;
    sample_.position = vec3(uintBitsToFloat(texel_.x), uintBitsToFloat(texel_.y), uintBitsToFloat(texel_.z));
    sample_.own = texel_.w;
    return sample_;
}

GNO_NAMESPACE_END
#endif
