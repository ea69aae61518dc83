#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Must fail with the #error of core/transmittance.glsl that names GNO_LOAD_MATERIAL.
#define GNO_LOAD_MATERIAL_OF(caster) caster
#define GNO_LOAD_SURFACE(index) GnoSurface(ivec2(0), ivec2(0), ivec2(0), index, 0u)
#define GNO_LOAD_TEXEL(index) index
#include "gnomon/core/transmittance.glsl"
layout(local_size_x = 64) in;
void main() {}
