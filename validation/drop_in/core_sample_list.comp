#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/sample.glsl as a list; the device test of it runs this shader.
#include "gnomon/core/sample.glsl"
layout(local_size_x = 64) in;
struct Question { vec4 p, a, b, c, viewer, light; };
struct Answer { vec4 snapped; uvec4 texel; };
layout(set = 0, binding = 0, std430) readonly buffer Questions { Question v[]; } questions;
layout(set = 0, binding = 1, std430) writeonly buffer Answers { Answer v[]; } answers;

void main() {
    uint at = gl_GlobalInvocationID.x;
    if (at >= uint(answers.v.length())) return;
    Question q = questions.v[at];
    GnoViewSample s = gnoMakeViewSample(q.p.xyz, at, GnoCaster(q.a.xyz, q.b.xyz, q.c.xyz), q.viewer, q.light);
    answers.v[at] = Answer(vec4(gnoSnapToGrid(q.p.xyz), 0.0), gnoPackViewSample(s));
}
