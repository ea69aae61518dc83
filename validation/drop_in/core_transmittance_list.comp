#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/transmittance.glsl over a list of questions; the device test of it runs this shader.
layout(push_constant) uniform Push { uint count; } push;
#include "gnomon/core/material_bindings.glsl"
#include "gnomon/core/transmittance.glsl"
struct Question { vec4 light; vec4 a; vec4 b; vec4 c; vec4 p; };
layout(set = 1, binding = 0, std430) readonly buffer Questions { Question v[]; } questions;
layout(set = 1, binding = 1, std430) writeonly buffer Answers { uvec4 v[]; } answers;  // weights and their mean of 0, 2^31, 2^32 - 1; contribution
layout(local_size_x = 64) in;

void main() {
    uint at = gl_GlobalInvocationID.x;
    if (at >= push.count) return;
    Question q = questions.v[at];
    GnoCaster t = GnoCaster(q.a.xyz, q.b.xyz, q.c.xyz);
    uvec3 weights = gnoHitWeights(q.light, t, q.p.xyz);
    answers.v[2u * at] = uvec4(weights, gnoWeightedMean(weights, uvec3(0u, 0x80000000u, 0xFFFFFFFFu)));
    answers.v[2u * at + 1u] = uvec4(gnoTransmittance(at, t, q.light, q.p.xyz), gnoContribution(at & 255u));
}
