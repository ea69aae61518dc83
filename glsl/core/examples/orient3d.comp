// SPDX-License-Identifier: MIT
// gnomon core/examples/orient3d.comp : core/orient3d.glsl over a list of questions; a device test compares the answers with the CPU's, bit for bit.
//
// A question is a light, a caster and a point; the shader writes one answer per question and leaves alone what lies beyond the shorter list.
#version 450
#extension GL_GOOGLE_include_directive : require
#ifndef GNO_ORIENT3D_SET
#define GNO_ORIENT3D_SET 0
#endif
#ifndef GNO_ORIENT3D_BINDING_QUESTIONS
#define GNO_ORIENT3D_BINDING_QUESTIONS 0
#endif
#ifndef GNO_ORIENT3D_BINDING_ANSWERS
#define GNO_ORIENT3D_BINDING_ANSWERS 1
#endif
#ifndef GNO_ORIENT3D_GROUP_SIZE
#define GNO_ORIENT3D_GROUP_SIZE 64
#endif
#include "../orient3d.glsl"

layout(local_size_x = GNO_ORIENT3D_GROUP_SIZE) in;

struct Question {  // 80 bytes
    vec4 light;    //  0  homogeneous
    vec4 a;        // 16  xyz: the caster's vertices; w unused
    vec4 b;        // 32
    vec4 c;        // 48
    vec4 p;        // 64
};

struct Answer {      // 32 bytes
    int orient;      //  0  gnoOrient3d(a, b, c, p)
    int facing;      //  4  gnoFacing(light, (a, b, c))
    int lateral;     //  8  gnoOrient3dLight(light, a, b, p)
    uint inShadow;   // 12  gnoInShadowOf(light, (a, b, c), p): 0 or 1
    vec4 normal;     // 16  xyz gnoExactNormal((a, b, c)); w = 0
};

layout(set = GNO_ORIENT3D_SET, binding = GNO_ORIENT3D_BINDING_QUESTIONS, std430) readonly buffer Questions { Question questions[]; };
layout(set = GNO_ORIENT3D_SET, binding = GNO_ORIENT3D_BINDING_ANSWERS, std430) writeonly buffer Answers { Answer answers[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= min(uint(questions.length()), uint(answers.length()))) {
        return;
    }
    Question q = questions[index];
    GnoCaster t = GnoCaster(q.a.xyz, q.b.xyz, q.c.xyz);
    Answer answer;
    answer.orient = gnoOrient3d(t.a, t.b, t.c, q.p.xyz);
    answer.facing = gnoFacing(q.light, t);
    answer.lateral = gnoOrient3dLight(q.light, t.a, t.b, q.p.xyz);
    answer.inShadow = gnoInShadowOf(q.light, t, q.p.xyz) ? 1u : 0u;
    answer.normal = vec4(gnoExactNormal(t), 0.0);
    answers[index] = answer;
}
