#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// One work group per tile, one invocation per pixel of it: 64, or 32 in the flat form.
#include "../../core/constant_ids.h"
layout(local_size_x = 64, local_size_x_id = GNO_ID_GROUP_SIZE) in;
layout(constant_id = GNO_ID_FORM) const uint kForm = 1u;
#define GNO_CLUSTER_FORM kForm
layout(constant_id = GNO_ID_WHAT) const uint kWhat = 3u;
#include "../../core/sample.glsl"
#define GNO_CLUSTER_BUILDS GNO_CLUSTER_PASS_TILES
#include "../bindings.glsl"
#include "../build.glsl"
layout(set = 2, binding = 2, rgba32ui) uniform readonly uimage2D gnoSamples;

void main() {
    uvec2 tile = gl_WorkGroupID.xy;
    uvec2 pixel = gnoClusterTilePixel(GNO_CLUSTER_FORM, tile, gl_LocalInvocationID.x);
    GnoViewSample s = GnoViewSample(vec3(0.0), GNO_BACKGROUND);
    if (all(lessThan(pixel, GNO_CLUSTER_FRAME.size))) s = gnoUnpackViewSample(imageLoad(gnoSamples, ivec2(pixel)));
    gnoClusterAddTile(tile, gl_LocalInvocationID.x, s, kWhat);
}
