// SPDX-License-Identifier: MIT
// gnomon rivals/ray_query.glsl : is a point in shadow? A ray towards the light, asked of the device's own acceleration structure
// (GLSL_EXT_ray_query).
//
//   bool gnoRayQueryInShadow(GnoViewSample s)      true: the ray meets a caster other than s.own
//   uint gnoRayQueryAnswer(GnoViewSample s)        the same as GNO_VISIBILITY_SHADOW or _LIT; a structure of the device's has no word to check
//
// The ray runs from the sample to the light, with the unnormalised direction to a point light and t from 0 to the last fp32 number below 1, or along
// a direction with t from 0 to 8 (the grid's cube is left by t = 4.1). It ends at the first caster that is not the sample's own; the own one is
// passed, so every triangle is a candidate that the loop confirms or not, whatever its geometry's flags. There is no bias: a view sample already
// lies off its own plane. The device decides in fp32, by a test that Vulkan leaves to the driver: near an edge or a tie it may differ from the
// definition (README "What in shadow means"). Nothing is certified here; the rung is `published`.
//
// Space      s.position on the scene grid, s.own the caster it lies on or GNO_NO_CASTER; the structure holds the casters on the same grid,
//            untransformed
// Stages     any with ray queries; no barrier, no shared memory, may diverge
// Requires   #version 460, #extension GL_EXT_ray_query, SPIR-V 1.4; rayQuery and accelerationStructure
// Reads      the acceleration structure through GNO_RAY_QUERY_STRUCTURE; writes nothing; declares no binding
// Cost       one ray query
//
// Macro                        required  default  meaning
// GNO_RAY_QUERY_STRUCTURE      yes       -        accelerationStructureEXT, top level: the casters that are kept (rivals/ray_query_index.glsl)
// GNO_LIGHT                    yes       -        vec4, homogeneous: xyz position and w = 1, or direction towards the light and w = 0
// GNO_RAY_QUERY_CASTER(query)  no        -        uint, caster index of the candidate of a rayQueryEXT; without it, its primitive index
#ifndef GNO_RIVALS_RAY_QUERY_GLSL
#define GNO_RIVALS_RAY_QUERY_GLSL
#include "../core/counters.glsl"
#include "../core/shared_types.h"
#ifndef GNO_RAY_QUERY_STRUCTURE
#error "rivals/ray_query.glsl: define GNO_RAY_QUERY_STRUCTURE or include rivals/ray_query_bindings.glsl before this file"
#endif
#ifndef GNO_LIGHT
#error "rivals/ray_query.glsl: define GNO_LIGHT before this file"
#endif

bool gnoRayQueryInShadow(GnoViewSample s_) {
    vec4 light_ = GNO_LIGHT;
    vec3 towards_ = light_.w == 0.0 ? light_.xyz : light_.xyz - s_.position;
    if (towards_ == vec3(0.0)) return false;  // at the light
    float end_ = light_.w == 0.0 ? 8.0 : 0.999999940395355224609375;
    rayQueryEXT query_;
    rayQueryInitializeEXT(query_, GNO_RAY_QUERY_STRUCTURE, gl_RayFlagsTerminateOnFirstHitEXT | gl_RayFlagsNoOpaqueEXT, 0xFFu, s_.position, 0.0,
                          towards_, end_);
    GNO_COUNT(rays, 1u);
    while (rayQueryProceedEXT(query_)) {
        GNO_COUNT(candidates, 1u);
#ifdef GNO_RAY_QUERY_CASTER
        uint caster_ = GNO_RAY_QUERY_CASTER(query_);
#else
        uint caster_ = uint(rayQueryGetIntersectionPrimitiveIndexEXT(query_, false));
#endif
        if (caster_ != s_.own) rayQueryConfirmIntersectionEXT(query_);
    }
    return rayQueryGetIntersectionTypeEXT(query_, true) != gl_RayQueryCommittedIntersectionNoneEXT;
}

uint gnoRayQueryAnswer(GnoViewSample s_) { return gnoRayQueryInShadow(s_) ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT; }
#endif
