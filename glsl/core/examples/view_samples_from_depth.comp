#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Depth and normal to view samples, one invocation per pixel, where no primitive is known. Yours reads its own depth buffer and normals.
#include "../sample_from_depth.glsl"
#include "../shared_types.h"
#include "frame.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 2, binding = 2, rgba32ui) uniform writeonly uimage2D gnoSamples;
layout(set = 2, binding = 25, r32f) uniform readonly image2D gnoDepths;     // 0: nothing was drawn
layout(set = 2, binding = 26, rgba32f) uniform readonly image2D gnoNormals;
layout(set = 2, binding = 27, std140) uniform GnoExampleUnprojection {
    mat4 gridFromClip;
    float depthStep;  // GNO_DEPTH_STEP_D32 ...
    float subPixels;  // 2^subPixelPrecisionBits
} gnoUnprojection;

void main() {
    if (any(greaterThanEqual(gl_GlobalInvocationID.xy, gnoPush.size))) return;
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    float depth = imageLoad(gnoDepths, pixel).x;
    GnoViewSample s = GnoViewSample(vec3(0.0), GNO_BACKGROUND);
    if (depth != 0.0) {
        vec2 ndc = (vec2(pixel) + 0.5) * 2.0 / vec2(gnoPush.size) - 1.0;
        vec3 n = normalize(imageLoad(gnoNormals, pixel).xyz);
        vec3 p = gnoPositionFromDepth(gnoUnprojection.gridFromClip, ndc, depth);
        vec2 snap = 2.0 / (vec2(gnoPush.size) * gnoUnprojection.subPixels);
        float error = gnoDepthError(gnoUnprojection.gridFromClip, ndc, depth, n, gnoUnprojection.depthStep, snap);
        s = gnoMakeViewSampleFromNormal(p, n, error, gnoPush.viewer, gnoPush.light);
    }
    imageStore(gnoSamples, pixel, gnoPackViewSample(s));
}
