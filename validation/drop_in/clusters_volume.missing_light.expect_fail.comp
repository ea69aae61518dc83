#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Must fail with the #error of clusters/volume.glsl that names GNO_LIGHT.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/bindings.glsl"
#define GNO_CLUSTER_FORM GNO_CLUSTER_COMPACT
#include "gnomon/clusters/bindings.glsl"
#include "gnomon/clusters/volume.glsl"
layout(local_size_x = 64) in;
void main() {}
