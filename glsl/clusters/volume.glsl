// SPDX-License-Identifier: MIT
// gnomon clusters/volume.glsl : the shadow volume of a caster as planes, and three more that cull what lies in the wedges between them.
// After Sintorn et al., I3D 2014, section 2 ("Triangle Setup", figure 4) and, for the flat form, the two silhouette edges of SIGGRAPH Asia 2011.
//
//   void gnoClusterSetUpVolume(uint caster, int facing)         writes the caster's 7 planes and its info; facing 0: it is left out
//   void gnoClusterFinishVolumes()                              one invocation of the same pass: the header says that there are volumes
//
// Per caster: lateral planes of ab, bc, ca and the capping plane, inside negative (top/plane.glsl: two casters that share an edge have the same
// plane, up to its sign);
// then three planes that hold the whole volume on their negative side, zero where there is none:
//   implicit, explicit, compact    for each vertex, through light and vertex, the half vector of the adjacent lateral planes' normals turned to a
//   right angle with the ray
//   flat                           through light, viewer and a vertex, where the other two vertices lie on one side: at most two of the three do
// An extra plane is kept only when its safety was seen. Let g be its side. Point light: g(v_i) <= 2E|v_i| (computed; 5u more exactly) for the three
// vertices, and s, the cosine that gnoTopSpread bounds from below, above 1/2. A point of the volume is q = sum l_i v_i, l_i >= 0, and |q| >= s sum
// l_i |v_i|, so g(q) <= 3E|q|/s < 6E|q|.
// Directional: g(v_i) <= 2ES and |n.D'| <= 2E, a point is x - mu D' with mu <= 2S: g < 7ES. A node is rejected when all of it has g > 8E scale, one
// E for rounding.
//
// Space      casters on the scene grid; planes in the coordinates of gnoFromLight; facing = gnoFacing(light, caster), exact
// Stages     any with storage buffers; no barrier, may diverge
// Requires   #version 450, no extension
// Reads      casters
// Writes     volumes, info, header
//
// Macro                     required  default                   meaning
// GNO_CLUSTER_BUILDS        no        1                         GNO_CLUSTER_PASS_VOLUMES, alone or with | among others, or 1
// GNO_CLUSTER_HEADER        yes       -                         GnoClusterHeader in a storage buffer
// GNO_CLUSTER_VOLUMES       yes       -                         array of vec4, 7 per caster
// GNO_CLUSTER_INFO          yes       -                         array of uvec2, one per caster: facing + 1; largest gnoLightScale, float bits
// GNO_CLUSTER_FRAME         yes       -                         GnoClusterFrame
// GNO_CLUSTER_FORM          yes       -                         GNO_CLUSTER_IMPLICIT, ..._EXPLICIT, ..._COMPACT or ..._FLAT
// GNO_LIGHT                 yes       -                         vec4, homogeneous (core/light.glsl)
// GNO_LOAD_CASTER(index)    yes       -                         GnoCaster
// GNO_PRECISION             no        GNO_PRECISION_CERTIFIED   rung of the ladder; the traversal must use the same
#ifndef GNO_CLUSTERS_VOLUME_GLSL
#define GNO_CLUSTERS_VOLUME_GLSL
#include "../top/plane.glsl"
#include "cluster.h"
#ifndef GNO_CLUSTER_BUILDS
#define GNO_CLUSTER_BUILDS 1
#endif
#if !((GNO_CLUSTER_BUILDS) & (1 | GNO_CLUSTER_PASS_VOLUMES))
#error "clusters/volume.glsl: which pass is this? define GNO_CLUSTER_BUILDS before clusters/bindings.glsl, as clusters/cluster.h says"
#endif
#ifndef GNO_CLUSTER_HEADER
#error "clusters/volume.glsl: define GNO_CLUSTER_HEADER (or include bindings.glsl)"
#endif
#if !defined(GNO_CLUSTER_VOLUMES) || !defined(GNO_CLUSTER_INFO) || !defined(GNO_CLUSTER_FRAME) || !defined(GNO_CLUSTER_FORM)
#error "clusters/volume.glsl: define GNO_CLUSTER_VOLUMES, GNO_CLUSTER_INFO, GNO_CLUSTER_FRAME and GNO_CLUSTER_FORM (or include bindings.glsl)"
#endif
#ifndef GNO_LIGHT
#error "clusters/volume.glsl: define GNO_LIGHT, a homogeneous vec4"
#endif
#ifndef GNO_LOAD_CASTER
#error "clusters/volume.glsl: define GNO_LOAD_CASTER(index) or include core/bindings.glsl before this file"
#endif
#ifndef GNO_PRECISION
#define GNO_PRECISION GNO_PRECISION_CERTIFIED
#endif
GNO_NAMESPACE_BEGIN

// The plane if it is safe, else zero. q: the vertices relative to the light.
GNO_INLINE vec4 gnoClusterIfSafe_(vec4 plane_, vec3 qa_, vec3 qb_, vec3 qc_, float spread_) {
    float most_ = 2.0f * GNO_BAND;
    bool safe_ = gnoTopSide(plane_, qa_) <= most_ * gnoLightScale(GNO_LIGHT, qa_) &&
                 gnoTopSide(plane_, qb_) <= most_ * gnoLightScale(GNO_LIGHT, qb_) &&
                 gnoTopSide(plane_, qc_) <= most_ * gnoLightScale(GNO_LIGHT, qc_);
    if (GNO_LIGHT.w == 0.0f) {
        vec3 towards_ = gnoTopUnit_(vec3(GNO_LIGHT.x, GNO_LIGHT.y, GNO_LIGHT.z));
        safe_ = safe_ && abs(gnoDot(vec3(plane_.x, plane_.y, plane_.z), towards_)) <= 2.0f * GNO_BAND;
    } else {
        safe_ = safe_ && spread_ > 0.5f;
    }
    return safe_ ? plane_ : vec4(0.0f);
}

// Through the ray of vertex v (relative to the light), with the half vector of two lateral planes' normals.
GNO_INLINE vec4 gnoClusterWedgePlane_(vec4 first_, vec4 second_, vec3 v_) {
    vec3 half_ = gnoTopUnit_(vec3(first_.x, first_.y, first_.z)) + gnoTopUnit_(vec3(second_.x, second_.y, second_.z));
    if (!(gnoLength(half_) > 0.01f)) return vec4(0.0f);  // neighbours turned back to back: a needle
    vec3 along_ = gnoTopUnit_(GNO_LIGHT.w != 0.0f ? v_ : vec3(GNO_LIGHT.x, GNO_LIGHT.y, GNO_LIGHT.z));
    vec3 n_ = gnoTopUnit_(half_);
    n_ = gnoTopUnit_(n_ - along_ * gnoDot(n_, along_)) * (1.0f - GNO_BAND);
    return vec4(n_, GNO_LIGHT.w != 0.0f ? 0.0f : -gnoDot(n_, v_));
}

// Through light, viewer and vertex v, v on its zero side and both others on the negative one, if they are on one side.
GNO_INLINE vec4 gnoClusterSilhouettePlane_(vec3 v_, vec3 other_, vec3 third_) {
    vec4 viewer_ = GNO_CLUSTER_FRAME.origin;
    vec3 ray_ = GNO_LIGHT.w != 0.0f ? v_ : vec3(GNO_LIGHT.x, GNO_LIGHT.y, GNO_LIGHT.z);
    vec3 sight_ = vec3(GNO_CLUSTER_FRAME.forward.x, GNO_CLUSTER_FRAME.forward.y, GNO_CLUSTER_FRAME.forward.z);
    if (viewer_.w != 0.0f) sight_ = gnoFromLight(GNO_LIGHT, vec3(viewer_.x, viewer_.y, viewer_.z)) - (GNO_LIGHT.w != 0.0f ? vec3(0.0f) : v_);
    vec3 n_ = gnoTopUnit_(gnoCross(gnoTopUnit_(ray_), gnoTopUnit_(sight_)));
    n_ = gnoTopUnit_(n_) * (1.0f - GNO_BAND);
    float offset_ = GNO_LIGHT.w != 0.0f ? 0.0f : -gnoDot(n_, v_);
    vec4 plane_ = vec4(n_, offset_);
    return gnoTopSide(plane_, other_) + gnoTopSide(plane_, third_) > 0.0f ? -plane_ : plane_;
}

GNO_INLINE void gnoClusterFinishVolumes() { GNO_CLUSTER_HEADER.volumes = gnoState(GNO_PRECISION); }

GNO_INLINE void gnoClusterSetUpVolume(uint caster_, int facing_) {
    uint at_ = 7u * caster_;
    GNO_CLUSTER_INFO[caster_] = uvec2(uint(facing_ + 1), 0u);
    if (facing_ == 0) return;
    GnoCaster t_ = GNO_LOAD_CASTER(caster_);
    vec4 ab_ = gnoTopLateralPlane(GNO_LIGHT, t_.a, t_.b, facing_, GNO_PRECISION);
    vec4 bc_ = gnoTopLateralPlane(GNO_LIGHT, t_.b, t_.c, facing_, GNO_PRECISION);
    vec4 ca_ = gnoTopLateralPlane(GNO_LIGHT, t_.c, t_.a, facing_, GNO_PRECISION);
    GNO_CLUSTER_VOLUMES[at_] = ab_;
    GNO_CLUSTER_VOLUMES[at_ + 1u] = bc_;
    GNO_CLUSTER_VOLUMES[at_ + 2u] = ca_;
    GNO_CLUSTER_VOLUMES[at_ + 3u] = gnoTopCapPlane(GNO_LIGHT, t_, facing_, GNO_PRECISION);
    vec3 qa_ = gnoFromLight(GNO_LIGHT, t_.a);
    vec3 qb_ = gnoFromLight(GNO_LIGHT, t_.b);
    vec3 qc_ = gnoFromLight(GNO_LIGHT, t_.c);
    float spread_ = gnoTopSpread(GNO_LIGHT, qa_, qb_, qc_);
    vec4 a_, b_, c_;
    if (GNO_CLUSTER_FORM == GNO_CLUSTER_FLAT) {
        a_ = gnoClusterSilhouettePlane_(qa_, qb_, qc_);
        b_ = gnoClusterSilhouettePlane_(qb_, qc_, qa_);
        c_ = gnoClusterSilhouettePlane_(qc_, qa_, qb_);
    } else {
        a_ = gnoClusterWedgePlane_(ca_, ab_, qa_);
        b_ = gnoClusterWedgePlane_(ab_, bc_, qb_);
        c_ = gnoClusterWedgePlane_(bc_, ca_, qc_);
    }
    GNO_CLUSTER_VOLUMES[at_ + 4u] = gnoClusterIfSafe_(a_, qa_, qb_, qc_, spread_);
    GNO_CLUSTER_VOLUMES[at_ + 5u] = gnoClusterIfSafe_(b_, qa_, qb_, qc_, spread_);
    GNO_CLUSTER_VOLUMES[at_ + 6u] = gnoClusterIfSafe_(c_, qa_, qb_, qc_, spread_);
    float reach_ = max(gnoLightScale(GNO_LIGHT, qa_), max(gnoLightScale(GNO_LIGHT, qb_), gnoLightScale(GNO_LIGHT, qc_)));
    GNO_CLUSTER_INFO[caster_] = uvec2(uint(facing_ + 1), floatBitsToUint(reach_));
}

GNO_NAMESPACE_END
#endif
