#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Step 1: how far the view samples of each cell lie. One invocation per pixel.
layout(local_size_x = 8, local_size_y = 8) in;
#include "../../core/sample.glsl"
#include "../../core/examples/frame.glsl"
#include "../bindings.glsl"
#include "../assign.glsl"
layout(set = 2, binding = 0, rgba32ui) uniform readonly uimage2D gnoSamples;

void main() {
    if (any(greaterThanEqual(gl_GlobalInvocationID.xy, gnoPush.size))) return;
    GnoViewSample s = gnoUnpackViewSample(imageLoad(gnoSamples, ivec2(gl_GlobalInvocationID.xy)));
    if (s.own <= GNO_NO_CASTER) gnoForestSeeSample(s.position);
}
