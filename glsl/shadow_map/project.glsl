// SPDX-License-Identifier: MIT
// gnomon shadow_map/project.glsl : a point in a view of a shadow map; both the vertex shader that draws the map and the query use it.
//
//   vec4 gnoShadowMapClip(GnoShadowMapView view, vec3 q)       clip coordinates: what a vertex shader writes to gl_Position
//   bool gnoShadowMapHolds(vec4 clip)                          the view's pyramid, or its prism, holds the point; edges belong to it
//   uvec2 gnoShadowMapTexel(vec4 clip, uint size)              the texel it lies in, of a map of size x size
//   float gnoShadowMapDepth(GnoShadowMapView view, vec4 clip)  what is compared with that texel, constant bias included; never below 0
//   bool gnoShadowMapDraws(uint state, uint faces)             is a caster drawn? `state` of core/caster_state.glsl; edge-on and culled ones never
//   are
//
// Space      as view.h
// Stages     any; pure
// Requires   #version 450, no extension
#ifndef GNO_SHADOW_MAP_PROJECT_GLSL
#define GNO_SHADOW_MAP_PROJECT_GLSL
#include "../core/caster_state.glsl"
#include "view.h"
GNO_NAMESPACE_BEGIN

GNO_INLINE vec4 gnoShadowMapClip(GnoShadowMapView view_, vec3 q_) {
    return vec4(gnoDot(vec3(view_.x), q_) + view_.x.w, gnoDot(vec3(view_.y), q_) + view_.y.w, gnoDot(vec3(view_.z), q_) + view_.z.w,
                gnoDot(vec3(view_.w), q_) + view_.w.w);
}

GNO_INLINE bool gnoShadowMapHolds(vec4 clip_) { return clip_.w > 0.0f && abs(clip_.x) <= clip_.w && abs(clip_.y) <= clip_.w; }

GNO_INLINE uvec2 gnoShadowMapTexel(vec4 clip_, uint size_) {
    float x_ = (clip_.x / clip_.w * 0.5f + 0.5f) * float(size_);
    float y_ = (clip_.y / clip_.w * 0.5f + 0.5f) * float(size_);
    float last_ = float(size_) - 1.0f;
    return uvec2(uint(clamp(x_, 0.0f, last_)), uint(clamp(y_, 0.0f, last_)));
}

GNO_INLINE float gnoShadowMapDepth(GnoShadowMapView view_, vec4 clip_) { return max(clip_.z / clip_.w * view_.bias.x + view_.bias.y, 0.0f); }

GNO_INLINE bool gnoShadowMapDraws(uint state_, uint faces_) {
    int facing_ = gnoCasterFacing(state_);  // below 0: the light sees the front
    return faces_ == GNO_SHADOW_MAP_BACK ? facing_ > 0 : faces_ == GNO_SHADOW_MAP_FRONT ? facing_ < 0 : facing_ != 0;
}

GNO_NAMESPACE_END
#endif
