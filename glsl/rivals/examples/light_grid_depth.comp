#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// How far the view samples of each sub cell lie. One invocation per pixel.
layout(local_size_x = 8, local_size_y = 8) in;
#include "../../core/sample.glsl"
#define GNO_LIGHT_GRID_BUILDS GNO_LIGHT_GRID_PASS_DEPTH
#include "light_grid_frame.glsl"
layout(set = 2, binding = 2, rgba32ui) uniform readonly uimage2D gnoSamples;

void main() {
    if (any(greaterThanEqual(gl_GlobalInvocationID.xy, gnoPush.size))) return;
    GnoViewSample s = gnoUnpackViewSample(imageLoad(gnoSamples, ivec2(gl_GlobalInvocationID.xy)));
    if (s.own <= GNO_NO_CASTER) gnoLightGridSeeSample(s.position);
}
