// SPDX-License-Identifier: MIT
// gnomon clusters/bounds.glsl : what a node of the hierarchy may hold, and on which side of a plane that lies.
// After Sintorn et al., I3D 2014, section 2 ("Traversal", trivial reject and trivial accept points) and 2.1; uncertainties are this project's.
//
//   GnoClusterBounds gnoClusterBox(vec4 light, vec3 low, vec3 high)       explicit: the exact least and largest coordinates of the node's samples
//   GnoClusterBounds gnoClusterCell(GnoClusterFrame frame, GnoClusterLayout layout, vec4 light, uvec2 first, uvec2 end,
//                                   float near, float far, float slack)
//        implicit and flat: tiles first <= tile < end, depths near .. far; every sample of the node lies within `slack` of that piece of the view
//   vec2  gnoClusterRange(GnoClusterFrame frame, vec4 light, GnoClusterBounds bounds, vec4 plane)        least and largest side over the bounds
//   float gnoClusterOutside(GnoClusterFrame frame, vec3 p, vec2 slopesLow, vec2 slopesHigh)  how far p lies outside the tile, for `slack`
//   vec2  gnoClusterSlope(GnoClusterFrame frame, uvec2 pixel)             slopes (orthographic: offsets) of a pixel's upper left corner
//
// Space      positions on the scene grid, planes in the coordinates of gnoFromLight, |xyz| <= 1
// Stages     any; pure
// Requires   #version 450, no extension
//
// When a side is certain. The exact plane through light and edge has one sign on all samples of a node when the stored plane's side is beyond
// `margin` of that sign on all of the bounds: top/plane.glsl, (2), (4) and (5), bound by E scale (cap: E (scale + reach), directional: 2 E S) how
// far both differ, scale being the largest
// |q| of the bounds; gnoTopMargin is three times that (directional: 6 E S). What is left, 2E scale, covers the rounding of the range of a box
// (differences, products and sums: 7u scale, E = 8u). A cell adds `uncertain`: its ranges have terms as large as T = |origin - light| + |offset| +
// depth (1 + slopes), each with at most 16u = 2E of relative error (the basis is orthonormal to 4u), taken twice; and slack, since |xyz| <= 1.
#ifndef GNO_CLUSTERS_BOUNDS_GLSL
#define GNO_CLUSTERS_BOUNDS_GLSL
#include "../core/light.glsl"
#include "cluster.h"
GNO_NAMESPACE_BEGIN

struct GnoClusterBounds {
    vec3 low;         // box: least coordinates relative to the light; cell: least slopes in xy, near in z
    vec3 high;        // box: largest; cell: largest slopes in xy, far in z
    float scale;      // largest gnoLightScale
    float uncertain;  // added to every margin
    bool boxed;       // true: a box
};

GNO_INLINE GnoClusterBounds gnoClusterBox(vec4 light_, vec3 low_, vec3 high_) {
    GnoClusterBounds bounds_;
    bounds_.low = gnoFromLight(light_, low_);
    bounds_.high = gnoFromLight(light_, high_);
    bounds_.scale = light_.w == 0.0f ? GNO_SCENE_RADIUS : gnoLength(max(abs(bounds_.low), abs(bounds_.high)));
    bounds_.uncertain = 0.0f;
    bounds_.boxed = true;
    return bounds_;
}

GNO_INLINE vec2 gnoClusterSlope(GnoClusterFrame frame_, uvec2 pixel_) {
    float x_ = (2.0f * float(pixel_.x) / float(frame_.size.x) - 1.0f) * frame_.right.w;
    float y_ = (2.0f * float(pixel_.y) / float(frame_.size.y) - 1.0f) * frame_.down.w;
    return vec2(x_, y_);
}

// Depths are widened by more than a device's exp2 may be off (Vulkan: 3 + 2 |x| ulp, |x| <= 40).
GNO_INLINE GnoClusterBounds gnoClusterCell(GnoClusterFrame frame_, GnoClusterLayout layout_, vec4 light_, uvec2 first_, uvec2 end_, float near_,
                                           float far_, float slack_) {
    uint height_ = gnoClusterTileHeight(layout_);
    vec2 from_ = gnoClusterSlope(frame_, uvec2(first_.x * GNO_CLUSTER_TILE, first_.y * height_));
    vec2 to_ = gnoClusterSlope(frame_, uvec2(end_.x * GNO_CLUSTER_TILE, end_.y * height_));
    float farthest_ = max(abs(near_), abs(far_)) * (1.0f + 1.52587890625e-5f);
    GnoClusterBounds bounds_;
    bounds_.low = vec3(from_.x, from_.y, near_ - abs(near_) * 1.52587890625e-5f);
    bounds_.high = vec3(to_.x, to_.y, far_ + abs(far_) * 1.52587890625e-5f);
    float wide_ = max(abs(from_.x), abs(to_.x)) + max(abs(from_.y), abs(to_.y));
    float reach_ = frame_.origin.w != 0.0f ? farthest_ * (1.0f + wide_) : farthest_ + wide_;
    float distance_ = gnoLength(gnoFromLight(light_, vec3(frame_.origin.x, frame_.origin.y, frame_.origin.z)));
    bounds_.scale = light_.w == 0.0f ? GNO_SCENE_RADIUS : (distance_ + reach_) * 1.001f + slack_;
    bounds_.uncertain = 4.0f * GNO_BAND * (distance_ + reach_ + 2.0f * GNO_SCENE_RADIUS) + slack_;
    bounds_.boxed = false;
    return bounds_;
}

GNO_INLINE vec2 gnoClusterRange(GnoClusterFrame frame_, vec4 light_, GnoClusterBounds bounds_, vec4 plane_) {
    vec3 n_ = vec3(plane_.x, plane_.y, plane_.z);
    if (bounds_.boxed) {
        vec3 a_ = n_ * bounds_.low;
        vec3 b_ = n_ * bounds_.high;
        vec3 least_ = min(a_, b_);
        vec3 most_ = max(a_, b_);
        return vec2((least_.x + least_.y) + (least_.z + plane_.w), (most_.x + most_.y) + (most_.z + plane_.w));
    }
    float start_ = gnoDot(n_, gnoFromLight(light_, vec3(frame_.origin.x, frame_.origin.y, frame_.origin.z))) + plane_.w;
    float right_ = gnoDot(n_, vec3(frame_.right.x, frame_.right.y, frame_.right.z));
    float down_ = gnoDot(n_, vec3(frame_.down.x, frame_.down.y, frame_.down.z));
    float forward_ = gnoDot(n_, vec3(frame_.forward.x, frame_.forward.y, frame_.forward.z));
    float x0_ = right_ * bounds_.low.x;
    float x1_ = right_ * bounds_.high.x;
    float y0_ = down_ * bounds_.low.y;
    float y1_ = down_ * bounds_.high.y;
    float least_ = min(x0_, x1_) + min(y0_, y1_);
    float most_ = max(x0_, x1_) + max(y0_, y1_);
    if (frame_.origin.w == 0.0f) {  // parallel view: slopes are offsets
        float z0_ = forward_ * bounds_.low.z;
        float z1_ = forward_ * bounds_.high.z;
        return vec2(start_ + (least_ + min(z0_, z1_)), start_ + (most_ + max(z0_, z1_)));
    }
    least_ += forward_;  // per unit of depth
    most_ += forward_;
    float low_ = min(min(bounds_.low.z * least_, bounds_.low.z * most_), min(bounds_.high.z * least_, bounds_.high.z * most_));
    float high_ = max(max(bounds_.low.z * least_, bounds_.low.z * most_), max(bounds_.high.z * least_, bounds_.high.z * most_));
    return vec2(start_ + low_, start_ + high_);
}

// The distance from p to the point of its own depth inside the tile, rounded up generously: 1.5 > sqrt(2) times the larger of both axes, and 2^-19
// of the way from the viewer for the rounding of the basis and of this function.
GNO_INLINE float gnoClusterOutside(GnoClusterFrame frame_, vec3 p_, vec2 slopesLow_, vec2 slopesHigh_) {
    vec3 d_ = p_ - vec3(frame_.origin.x, frame_.origin.y, frame_.origin.z);
    float x_ = gnoDot(vec3(frame_.right.x, frame_.right.y, frame_.right.z), d_);
    float y_ = gnoDot(vec3(frame_.down.x, frame_.down.y, frame_.down.z), d_);
    float z_ = frame_.origin.w != 0.0f ? gnoDot(vec3(frame_.forward.x, frame_.forward.y, frame_.forward.z), d_) : 1.0f;
    float outX_ = max(min(slopesLow_.x * z_, slopesHigh_.x * z_) - x_, x_ - max(slopesLow_.x * z_, slopesHigh_.x * z_));
    float outY_ = max(min(slopesLow_.y * z_, slopesHigh_.y * z_) - y_, y_ - max(slopesLow_.y * z_, slopesHigh_.y * z_));
    return 1.5f * max(0.0f, max(outX_, outY_)) + 1.9073486328125e-6f * gnoLength(d_);
}

GNO_NAMESPACE_END
#endif
