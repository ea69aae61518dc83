#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Pass 1 of a shadow map: one invocation per pixel; where in the views the view samples lie.
#define GNO_SHADOW_MAP_MEASURES 1
#include "../../core/sample.glsl"
#include "../../core/examples/frame.glsl"
#include "../bindings.glsl"
#include "../fit.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 2, binding = 2, rgba32ui) uniform readonly uimage2D gnoSamples;

void main() {
    if (any(greaterThanEqual(gl_GlobalInvocationID.xy, gnoPush.size))) return;
    GnoViewSample s = gnoUnpackViewSample(imageLoad(gnoSamples, ivec2(gl_GlobalInvocationID.xy)));
    if (s.own <= GNO_NO_CASTER) gnoShadowMapMeasure(s);
}
