#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/hit_weights.glsl with our casters.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/bindings.glsl"
#include "gnomon/core/hit_weights.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    uvec3 weights = gnoHitWeights(push.light, GNO_LOAD_CASTER(at), push.position.xyz);
    result = vec4(vec3(weights), float(gnoWeightedMean(weights, uvec3(1u, 2u, 3u))));
}
