#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// No view holds a sample yet. One work group.
#define GNO_SHADOW_MAP_MEASURES 1
#include "../bindings.glsl"
layout(local_size_x = 32) in;

void main() {
    if (gl_LocalInvocationIndex < uint(gnoShadowMapBounds.v.length())) gnoShadowMapBounds.v[gl_LocalInvocationIndex] = 0u;
}
