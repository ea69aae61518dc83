#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Must fail with the #error of top/visit.glsl that names GNO_LIGHT.
#include "gnomon/core/bindings.glsl"
#include "gnomon/top/bindings.glsl"
#include "gnomon/top/query_hybrid.glsl"
layout(local_size_x = 64) in;
void main() {}
