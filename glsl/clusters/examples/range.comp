#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Dispatch 2: least and largest depth of the view samples, one invocation per pixel.
#include "../../core/constant_ids.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = GNO_ID_FORM) const uint kForm = 1u;
#define GNO_CLUSTER_FORM kForm
#include "../../core/sample.glsl"
#define GNO_CLUSTER_BUILDS GNO_CLUSTER_PASS_RANGE
#include "../bindings.glsl"
#include "../build.glsl"
layout(set = 2, binding = 2, rgba32ui) uniform readonly uimage2D gnoSamples;

void main() {
    GnoViewSample s = GnoViewSample(vec3(0.0), GNO_BACKGROUND);
    if (all(lessThan(gl_GlobalInvocationID.xy, GNO_CLUSTER_FRAME.size)))
        s = gnoUnpackViewSample(imageLoad(gnoSamples, ivec2(gl_GlobalInvocationID.xy)));
    gnoClusterMeasureDepth(s, gl_LocalInvocationIndex);
}
