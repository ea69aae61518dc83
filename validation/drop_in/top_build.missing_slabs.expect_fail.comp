#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Must fail with the #error of top/build.glsl that names GNO_TOP_SLABS.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#include "gnomon/core/bindings.glsl"
#include "gnomon/top/node.h"
layout(set = 0, binding = 1, std430) buffer Ours { GnoTopHeader header; vec4 planes[64]; GnoTopLink links[64]; } ours;
#define GNO_TOP_PLANES ours.planes
#define GNO_TOP_LINKS ours.links
#define GNO_TOP_HEADER ours.header
#define GNO_TOP_SLAB 1
#include "gnomon/top/build.glsl"
layout(local_size_x = 64) in;
void main() {}
