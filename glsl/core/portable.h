// SPDX-License-Identifier: MIT
// gnomon core/portable.h : what one source needs to be read by two compilers, glslang and C++20 (validation/support/glsl_as_cpp.hpp).
//
// Space      none: no positions
// Stages     any
// Requires   #version 450, no extension
//
// Rules for a file that both read: output parameters are written GNO_OUT(type) or GNO_INOUT(type); float literals end in f (1.0f); integer
// conversions are spelled out (uint(x), uvec3(x)); xyz of a vec4 is vec3(v), no swizzles beyond .x .y .z .w; no arrays as values; no `discard`,
// no gl_* built-ins. `precise` is written as usual and is empty in C++, which is built without contraction.
#ifndef GNO_CORE_PORTABLE_H
#define GNO_CORE_PORTABLE_H

#ifdef __cplusplus
#define GNO_OUT(type_) type_&
#define GNO_INOUT(type_) type_&
#else
#define GNO_OUT(type_) out type_
#define GNO_INOUT(type_) inout type_
#endif

#endif
