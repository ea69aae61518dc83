#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// How far the view samples of each cell lie. One invocation per 4 x 2 pixels: neighbours lie in the same cell as a rule, one atomic for them all.
layout(local_size_x = 8, local_size_y = 8) in;
#include "../../core/sample.glsl"
#include "../../core/examples/frame.glsl"
#define GNO_FOREST_BUILDS GNO_FOREST_PASS_DEPTH
#include "../bindings.glsl"
#include "../assign.glsl"
layout(set = 2, binding = 2, rgba32ui) uniform readonly uimage2D gnoSamples;

void main() {
    GnoForestSeen seen = gnoForestSeen();
    for (uint n = 0u; n < 8u; ++n) {
        uvec2 pixel = gl_GlobalInvocationID.xy * uvec2(4u, 2u) + uvec2(n & 3u, n >> 2);
        if (any(greaterThanEqual(pixel, gnoPush.size))) continue;
        GnoViewSample s = gnoUnpackViewSample(imageLoad(gnoSamples, ivec2(pixel)));
        if (s.own <= GNO_NO_CASTER) gnoForestSeeSample(seen, s.position);
    }
    gnoForestTell(seen);
}
