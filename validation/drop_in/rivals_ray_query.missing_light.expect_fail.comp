#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_ray_query : require
// SPDX-License-Identifier: MIT
// Must fail with the #error of rivals/ray_query.glsl that names GNO_LIGHT.
#include "gnomon/rivals/ray_query_bindings.glsl"
#include "gnomon/rivals/ray_query.glsl"
layout(local_size_x = 64) in;
void main() {}
