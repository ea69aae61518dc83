#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Must fail with the #error of top/visit.glsl that names GNO_TOP_LOAD_SLAB.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#include "gnomon/core/bindings.glsl"
#include "gnomon/top/node.h"
layout(set = 0, binding = 1, std430) readonly buffer Ours { GnoTopNode node[64]; } ours;
#define GNO_TOP_LOAD_NODE(number) ours.node[number]
#define GNO_TOP_LOAD_ANCESTOR(number) ours.node[(number) - (number) % 4u + 1u].aux
#define GNO_TOP_LOAD_FLAGS(number) ours.node[(number) - (number) % 4u + 2u].aux
#define GNO_TOP_SLAB 1
#include "gnomon/top/query_stack.glsl"
layout(local_size_x = 64) in;
void main() {}
