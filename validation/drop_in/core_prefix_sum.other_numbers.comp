#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Another size of the work group; no array.
#define GNO_PREFIX_GROUP 128u
#include "gnomon/core/prefix_sum.glsl"
layout(local_size_x = 128) in;
layout(set = 2, binding = 9, std430) writeonly buffer Results { uint v[]; } results;

void main() {
    uint total;
    uint before = gnoGroupPrefix(gl_GlobalInvocationID.x, gl_LocalInvocationIndex, total);
    results.v[before] = total;
}
