// SPDX-License-Identifier: MIT
// gnomon rivals/light_grid_planes.glsl : the four planes of a caster in 64 bytes, so that most questions need no vertices.
//
//   vec4  gnoLightGridPlane(vec4 light, GnoCaster t, int facing, uint place)     0 .. 2: through the light and edges ab, bc, ca; 3: the caster's own
//   float gnoLightGridSide(vec4 light, vec4 plane, vec3 q)                       of a lateral plane: > 0 outside
//   float gnoLightGridReach(vec4 light, vec4 plane)                              from the plane at place 0: the caster's largest gnoLightScale
//
// A lateral plane of a point light passes through it and has no offset: the one at place 0 keeps the reach in its place. A plane that fp32 cannot
// tell is zero (top/plane.glsl, 1): every point lies in its band.
//
// Space      positions on the scene grid; q = gnoFromLight(p); facing = gnoFacing(light, t), never 0
// Stages     any; pure
// Requires   #version 450, no extension
#ifndef GNO_RIVALS_LIGHT_GRID_PLANES_GLSL
#define GNO_RIVALS_LIGHT_GRID_PLANES_GLSL
#include "../top/plane.glsl"
GNO_NAMESPACE_BEGIN

GNO_INLINE vec4 gnoLightGridPlane(vec4 light_, GnoCaster t_, int facing_, uint place_) {
    if (place_ == 3u) return gnoTopCapPlane(light_, t_, facing_, GNO_PRECISION_CERTIFIED);
    vec3 first_ = place_ == 0u ? t_.a : place_ == 1u ? t_.b : t_.c;
    vec3 second_ = place_ == 0u ? t_.b : place_ == 1u ? t_.c : t_.a;
    vec4 plane_ = gnoTopLateralPlane(light_, first_, second_, facing_, GNO_PRECISION_CERTIFIED);
    if (light_.w != 0.0f && place_ == 0u) {
        plane_.w = max(gnoLightScale(light_, gnoFromLight(light_, t_.a)),
                       max(gnoLightScale(light_, gnoFromLight(light_, t_.b)), gnoLightScale(light_, gnoFromLight(light_, t_.c))));
    }
    return plane_;
}

GNO_INLINE float gnoLightGridSide(vec4 light_, vec4 plane_, vec3 q_) {
    return gnoTopSide(vec4(vec3(plane_), light_.w != 0.0f ? 0.0f : plane_.w), q_);
}

GNO_INLINE float gnoLightGridReach(vec4 light_, vec4 plane_) { return light_.w != 0.0f ? plane_.w : 0.0f; }

GNO_NAMESPACE_END
#endif
