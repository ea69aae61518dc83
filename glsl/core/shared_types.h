// SPDX-License-Identifier: MIT
// gnomon core/shared_types.h : values that every module speaks of; read by glslang and by C++20 (namespace gno, with GLM).
//
// Space      positions are on the scene grid: fp32 multiples of 2^-40 in [-1, 1] (README "Conventions")
// Stages     any
// Requires   #version 450, no extension
#ifndef GNO_CORE_SHARED_TYPES_H
#define GNO_CORE_SHARED_TYPES_H
#include "version.h"

#ifdef __cplusplus
#include <cstddef>
#include <cstdint>

#include <glm/glm.hpp>
#define GNO_NAMESPACE_BEGIN namespace gno {
#define GNO_NAMESPACE_END }
#define GNO_CONST inline constexpr
#define GNO_INLINE inline
#define GNO_STRUCT_SIZE(type_, bytes_) static_assert(sizeof(type_) == (bytes_));
#define GNO_STRUCT_OFFSET(type_, member_, bytes_) static_assert(offsetof(type_, member_) == (bytes_));
namespace gno {
using uint = std::uint32_t;
using glm::uvec2;
using glm::uvec4;
using glm::vec3;
using glm::vec4;
}  // namespace gno
#else
#define GNO_NAMESPACE_BEGIN
#define GNO_NAMESPACE_END
#define GNO_CONST const
#define GNO_INLINE
#define GNO_STRUCT_SIZE(type_, bytes_)
#define GNO_STRUCT_OFFSET(type_, member_, bytes_)
#endif

GNO_NAMESPACE_BEGIN

// The precision ladder (README "Precision"): what GNO_PRECISION may be.
GNO_CONST uint GNO_PRECISION_PUBLISHED = 0u;     // as in the paper, fp32
GNO_CONST uint GNO_PRECISION_CONSERVATIVE = 1u;  // nothing is lost by routing or culling; fp32 decides the owner's own volume
GNO_CONST uint GNO_PRECISION_CERTIFIED = 2u;     // the same, and the owner's own volume is decided exactly

// GnoViewSample::own of what is not simply a sample on a caster. Caster indices stay below GNO_NO_CASTER.
GNO_CONST uint GNO_NO_CASTER = 0xFFFFFFFDu;      // a view sample that lies on no caster
GNO_CONST uint GNO_FACING_AWAY = 0xFFFFFFFEu;    // no view sample: its surface faces away from the light, dark by shading
GNO_CONST uint GNO_BACKGROUND = 0xFFFFFFFFu;     // no view sample: nothing is there

// What a visibility image holds.
GNO_CONST uint GNO_VISIBILITY_SHADOW = 0u;
GNO_CONST uint GNO_VISIBILITY_LIT = 1u;
GNO_CONST uint GNO_VISIBILITY_FACING_AWAY = 2u;
GNO_CONST uint GNO_VISIBILITY_BACKGROUND = 3u;
GNO_CONST uint GNO_VISIBILITY_UNKNOWN = 4u;      // the structure asked is not built, or not wholly, or for something else (core/state.h)

struct GnoCaster {      // a value; how casters lie in memory is the host's business (GNO_LOAD_CASTER)
    vec3 a;
    vec3 b;
    vec3 c;
};

struct GnoViewSample {  // a value; see core/sample.glsl for its packed form
    vec3 position;      // moved off its own caster's plane, towards the light's side
    uint own;           // the caster it lies on, or one of the constants above
};

GNO_NAMESPACE_END
#endif
