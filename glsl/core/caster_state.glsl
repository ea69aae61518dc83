// SPDX-License-Identifier: MIT
// gnomon core/caster_state.glsl : which triangles cast, and which way they face; run once per light and frame, for all techniques alike.
//
//   uint gnoCasterState(vec4 light, GnoCaster t, bool closed, uint cull, uint planeCount)
//        bits 0..1: facing + 1 (facing = gnoFacing, exact; 0 is seen edge-on and casts nothing)   bit 2: GNO_CASTER_KEPT
//   int  gnoCasterFacing(uint state)                    facing of a kept caster, 0 of one that is left out
//
// Front-face culling drops what faces the light, where `closed` says that nobody misses it: legal for closed, consistently oriented, wholly opaque
// meshes that neither camera nor near plane enters, where it changes no view sample's answer. Hull culling drops what lies outside the convex hull
// of view frustum and light; it never changes a view sample:
// a caster goes only when it is outside one plane of that hull by more than the plane's own margin.
//
// Space      casters and light on the scene grid; front = counter-clockwise seen from the light
// Stages     any; pure
// Requires   #version 450, no extension
//
// Macro                      required  default  meaning
// GNO_LOAD_CULL_PLANE(i)     no        -        vec4, i < planeCount; a vertex with dot(xyz, p) + w < 0 is outside, rounding allowed for; needed for
//                                               hull culling
#ifndef GNO_CORE_CASTER_STATE_GLSL
#define GNO_CORE_CASTER_STATE_GLSL
#include "light.glsl"
#include "orient3d.glsl"
GNO_NAMESPACE_BEGIN

GNO_CONST uint GNO_CASTER_KEPT = 4u;
GNO_CONST uint GNO_CULL_FRONT = 1u;  // bits of `cull`
GNO_CONST uint GNO_CULL_HULL = 2u;

GNO_INLINE uint gnoCasterState(vec4 light_, GnoCaster t_, bool closed_, uint cull_, uint planeCount_) {
    int facing_ = gnoFacing(light_, t_);
    uint state_ = uint(facing_ + 1);
    bool kept_ = facing_ != 0;
    if ((cull_ & GNO_CULL_FRONT) != 0u && closed_ && facing_ < 0) kept_ = false;  // orient3d(a, b, c, light) > 0: the front
#ifdef GNO_LOAD_CULL_PLANE
    if ((cull_ & GNO_CULL_HULL) != 0u) {
        for (uint i_ = 0u; i_ < planeCount_; ++i_) {
            vec4 plane_ = GNO_LOAD_CULL_PLANE(i_);
            vec3 n_ = vec3(plane_.x, plane_.y, plane_.z);
            float nearest_ = max(gnoDot(n_, t_.a), max(gnoDot(n_, t_.b), gnoDot(n_, t_.c))) + plane_.w;
            if (nearest_ < 0.0f) kept_ = false;
        }
    }
#endif
    return kept_ ? state_ | GNO_CASTER_KEPT : state_;
}

GNO_INLINE int gnoCasterFacing(uint state_) { return (state_ & GNO_CASTER_KEPT) != 0u ? int(state_ & 3u) - 1 : 0; }

GNO_NAMESPACE_END
#endif
