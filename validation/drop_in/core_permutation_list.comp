#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/permutation.glsl as a list; the device test of it runs this shader.
#include "gnomon/core/permutation.glsl"
layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint seed; } push;
layout(set = 0, binding = 0, std430) writeonly buffer Order { uint v[]; } order;

void main() {
    uint at = gl_GlobalInvocationID.x;
    if (at < push.count) order.v[at] = gnoPermute(at, push.count, push.seed);
}
