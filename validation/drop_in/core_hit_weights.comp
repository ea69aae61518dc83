#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/hit_weights.glsl with our casters.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/bindings.glsl"
#include "gnomon/core/hit_weights.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    uvec3 weights = gnoHitWeights(push.light, GNO_LOAD_CASTER(at), push.position.xyz);
    result = vec4(vec3(weights), float(gnoWeightedMean(weights, uvec3(1u, 2u, 3u))));
    results.v[at] = result;
}
