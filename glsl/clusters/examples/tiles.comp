#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// One work group per tile, one invocation per pixel of it: 64, or 32 in the flat form.
layout(local_size_x_id = 10) in;
layout(constant_id = 20) const uint kForm = 1u;
#define GNO_CLUSTER_FORM kForm
layout(constant_id = 21) const uint kWhat = 3u;
#include "../../core/sample.glsl"
#include "../bindings.glsl"
#include "../build.glsl"
layout(set = 2, binding = 0, rgba32ui) uniform readonly uimage2D gnoSamples;

void main() {
    uvec2 tile = gl_WorkGroupID.xy;
    uvec2 pixel = gnoClusterTilePixel(GNO_CLUSTER_FORM, tile, gl_LocalInvocationID.x);
    GnoViewSample s = GnoViewSample(vec3(0.0), GNO_BACKGROUND);
    if (all(lessThan(pixel, GNO_CLUSTER_FRAME.size))) s = gnoUnpackViewSample(imageLoad(gnoSamples, ivec2(pixel)));
    gnoClusterAddTile(tile, gl_LocalInvocationID.x, s, kWhat);
}
