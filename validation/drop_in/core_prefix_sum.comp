#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Sums in a work group, and over an array of the user's.
layout(set = 2, binding = 9, std430) buffer Results { uint v[]; } results;
#define GNO_PREFIX_WORDS results.v
#include "gnomon/core/prefix_sum.glsl"
layout(local_size_x = 64) in;

void main() {
    uint total;
    uint before = gnoGroupPrefix(gl_GlobalInvocationID.x, gl_LocalInvocationIndex, total);
    total += gnoArrayPrefix(total, gl_LocalInvocationIndex);
    results.v[before] = total;
}
