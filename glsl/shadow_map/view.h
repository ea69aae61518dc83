// SPDX-License-Identifier: MIT
// gnomon shadow_map/view.h : one view of a shadow map: a projection of everything the light sees, or of a part; read by glslang and by C++20
// (namespace gno).
// After Williams, "Casting Curved Shadows on Curved Surfaces", SIGGRAPH 1978; fitting to the view samples as Lauritzen, Salvi, Lefohn, "Sample
// Distribution Shadow Maps", I3D 2011.
//
// Space      q = gnoFromLight(light, p) of core/light.glsl, p on the scene grid; clip coordinates as Vulkan has them (y down, depth 0 .. 1), depth
//            reversed:
//            1 is nearest to the light, what is cleared is 0
// Stages     any
// Requires   #version 450, no extension
//
//   GnoShadowMapView gnoShadowMapPerspective(vec3 right, vec3 down, vec3 forward, vec4 rect)
//        from the light along `forward`; unit vectors; rect: least and largest slope to the right, then downwards (tangents; a cube's face is -1, 1,
//        -1, 1)
//   GnoShadowMapView gnoShadowMapOrthographic(vec3 right, vec3 down, vec3 forward, vec4 rect, float near, float far)
//        for a light at infinity; forward away from the light; rect: the same in grid units; near, far: along `forward`
//   GnoShadowMapView gnoShadowMapConstantBias(GnoShadowMapView view, float texels, float size)
//        the same view, in which a sample counts as nearer to the light by `texels` widths of a texel of a map of size x size texels
//   vec4 gnoShadowMapFit(uvec4 measured, vec4 rect)
//        the part of `rect` that holds the samples that shadow_map/fit.glsl measured, and a margin of 1/1024 of it; measured.x 0: there is none
//
// Perspective depth is GNO_SHADOW_MAP_NEAR / w with w the distance along `forward`: no far plane, and in fp32 the same relative step at every
// distance, so the near plane may stand so close to the light that all casters between light and samples are drawn: no depth clamp. Orthographic
// depth is (far - t) / (far
// - near), t along
// `forward`; near is that of the caster nearest to the light. A sample beyond far has a depth below 0 and is compared as 0: whatever was drawn is
// nearer.
#ifndef GNO_SHADOW_MAP_VIEW_H
#define GNO_SHADOW_MAP_VIEW_H
#include "../core/state.h"
GNO_NAMESPACE_BEGIN

GNO_CONST float GNO_SHADOW_MAP_NEAR = 9.5367431640625e-7f;  // 2^-20 grid units: nearer casters are clipped
GNO_CONST float GNO_SHADOW_MAP_STEPS = 16777216.0f;         // 2^24: a view's width in the units of shadow_map/fit.glsl

GNO_CONST uint GNO_SHADOW_MAP_BOTH = 0u;                    // faces that are drawn, as the light sees them
GNO_CONST uint GNO_SHADOW_MAP_BACK = 1u;
GNO_CONST uint GNO_SHADOW_MAP_FRONT = 2u;

struct GnoShadowMapView {  // std140 and std430, 80 bytes
    vec4 x;                //  0  rows of the projection: clip.x = dot(x.xyz, q) + x.w, and so on
    vec4 y;                // 16
    vec4 z;                // 32
    vec4 w;                // 48
    // 64  a sample's depth is clip.z / clip.w * bias.x + bias.y; z: the wider side of rect; w: depth per grid unit, 0 perspective
    vec4 bias;
};
GNO_STRUCT_SIZE(GnoShadowMapView, 80)
GNO_STRUCT_OFFSET(GnoShadowMapView, bias, 64)

struct GnoShadowMapHeader {  // std430, 16 bytes, before the views
    uint viewCount;        //  0
    uint size;             //  4  texels along a side
    uint state;            //  8  gnoState(GNO_STATE_ANY) once the views are filled in (core/state.h)
    uint unused0;          // 12
};
GNO_STRUCT_SIZE(GnoShadowMapHeader, 16)
GNO_STRUCT_OFFSET(GnoShadowMapHeader, size, 4)

GNO_INLINE float gnoShadowMapWidth_(vec4 rect_) { return rect_.y - rect_.x > rect_.w - rect_.z ? rect_.y - rect_.x : rect_.w - rect_.z; }

// Slope s in [low, high] goes to [-1, 1]: (2 s - low - high) / (high - low), times w.
GNO_INLINE GnoShadowMapView gnoShadowMapPerspective(vec3 right_, vec3 down_, vec3 forward_, vec4 rect_) {
    GnoShadowMapView view_;
    view_.x = vec4((2.0f * right_ - (rect_.x + rect_.y) * forward_) / (rect_.y - rect_.x), 0.0f);
    view_.y = vec4((2.0f * down_ - (rect_.z + rect_.w) * forward_) / (rect_.w - rect_.z), 0.0f);
    view_.z = vec4(0.0f, 0.0f, 0.0f, GNO_SHADOW_MAP_NEAR);
    view_.w = vec4(forward_, 0.0f);
    view_.bias = vec4(1.0f, 0.0f, gnoShadowMapWidth_(rect_), 0.0f);
    return view_;
}

GNO_INLINE GnoShadowMapView gnoShadowMapOrthographic(vec3 right_, vec3 down_, vec3 forward_, vec4 rect_, float near_, float far_) {
    GnoShadowMapView view_;
    view_.x = vec4(2.0f * right_ / (rect_.y - rect_.x), -(rect_.x + rect_.y) / (rect_.y - rect_.x));
    view_.y = vec4(2.0f * down_ / (rect_.w - rect_.z), -(rect_.z + rect_.w) / (rect_.w - rect_.z));
    view_.z = vec4(-forward_ / (far_ - near_), far_ / (far_ - near_));
    view_.w = vec4(0.0f, 0.0f, 0.0f, 1.0f);
    view_.bias = vec4(1.0f, 0.0f, gnoShadowMapWidth_(rect_), 1.0f / (far_ - near_));
    return view_;
}

// A texel is width / size wide, orthographic; perspective: that times w. So w becomes w (1 - texels width / size), or t becomes t - texels width /
// size.
GNO_INLINE GnoShadowMapView gnoShadowMapConstantBias(GnoShadowMapView view_, float texels_, float size_) {
    float step_ = texels_ * view_.bias.z / size_;
    if (view_.bias.w > 0.0f) view_.bias.y = step_ * view_.bias.w;
    else view_.bias.x = step_ < 1.0f ? 1.0f / (1.0f - step_) : 1.0f / GNO_SHADOW_MAP_NEAR;
    return view_;
}

GNO_INLINE vec4 gnoShadowMapFit(uvec4 measured_, vec4 rect_) {
    vec4 at_ = vec4(GNO_SHADOW_MAP_STEPS - float(measured_.x - 1u), float(measured_.y - 1u), GNO_SHADOW_MAP_STEPS - float(measured_.z - 1u),
                    float(measured_.w - 1u));
    float x_ = (at_.y - at_.x) / 1024.0f + 4.0f;  // steps: the measured positions are rounded down by up to one
    float y_ = (at_.w - at_.z) / 1024.0f + 4.0f;
    float right_ = (rect_.y - rect_.x) / GNO_SHADOW_MAP_STEPS;
    float down_ = (rect_.w - rect_.z) / GNO_SHADOW_MAP_STEPS;
    return vec4(rect_.x + (at_.x - x_) * right_, rect_.x + (at_.y + x_) * right_, rect_.z + (at_.z - y_) * down_, rect_.z + (at_.w + y_) * down_);
}

GNO_NAMESPACE_END
#endif
