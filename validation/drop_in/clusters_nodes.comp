#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_CLUSTER_FORM GNO_CLUSTER_COMPACT
#include "gnomon/clusters/bindings.glsl"
#include "gnomon/clusters/nodes.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    uint key = gnoClusterLeafKey(uvec2(at, push.seed), push.position.x);
    uvec2 pixel = gnoClusterTilePixel(GNO_CLUSTER_FORM, uvec2(at, push.seed), push.count);
    result = vec4(float(gnoClusterBoxIndex(1u, key)), float(gnoClusterSliceOf(push.position.x)), vec2(pixel));
    results.v[at] = result;
}
