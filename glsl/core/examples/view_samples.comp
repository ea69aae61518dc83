#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// G-buffer to view samples, one invocation per pixel.
#include "../bindings.glsl"
#include "../sample.glsl"
#include "frame.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 2, binding = 12, rgba32f) uniform readonly image2D gnoPositions;
layout(set = 2, binding = 13, r32ui) uniform readonly uimage2D gnoPrimitives;
layout(set = 2, binding = 2, rgba32ui) uniform writeonly uimage2D gnoSamples;

void main() {
    if (any(greaterThanEqual(gl_GlobalInvocationID.xy, gnoPush.size))) return;
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    uint primitive = imageLoad(gnoPrimitives, pixel).x;
    GnoViewSample s = GnoViewSample(vec3(0.0), GNO_BACKGROUND);
    if (primitive != GNO_BACKGROUND)
        s = gnoMakeViewSample(imageLoad(gnoPositions, pixel).xyz, primitive, GNO_LOAD_CASTER(primitive), gnoPush.viewer, gnoPush.light);
    imageStore(gnoSamples, pixel, gnoPackViewSample(s));
}
