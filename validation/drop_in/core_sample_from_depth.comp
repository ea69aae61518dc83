#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/sample_from_depth.glsl: a view sample of a depth and a normal.
layout(set = 1, binding = 0, std140) uniform Frame { mat4 gridFromClip; vec4 light; vec4 viewer; vec4 normal; vec2 size; } frame;
layout(set = 1, binding = 1) uniform sampler2D depths;
#include "gnomon/core/sample_from_depth.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    vec2 ndc = 2.0 * (vec2(float(at), 0.5)) / frame.size - 1.0;
    float depth = texelFetch(depths, ivec2(int(at), 0), 0).x;
    float error = gnoDepthError(frame.gridFromClip, ndc, depth, frame.normal.xyz, GNO_DEPTH_STEP_D24, 1.0 / (128.0 * frame.size));
    vec3 p = gnoPositionFromDepth(frame.gridFromClip, ndc, depth);
    GnoViewSample s = gnoMakeViewSampleFromNormal(p, frame.normal.xyz, error, frame.viewer, frame.light);
    result = vec4(s.position, float(s.own));
    results.v[at] = result;
}
