#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Must fail with the #error of top/build.glsl that names GNO_LOAD_CASTER.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#include "gnomon/top/bindings.glsl"
#include "gnomon/top/build.glsl"
layout(local_size_x = 64) in;
void main() {}
