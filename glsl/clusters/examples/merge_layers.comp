#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// One invocation per pixel, where some casters let light through: a sample is dark when nothing passes, whatever stood in the way.
#include "../../core/constant_ids.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = GNO_ID_FORM) const uint kForm = 1u;
#define GNO_CLUSTER_FORM kForm
#include "../../core/sample.glsl"
#include "../bindings.glsl"
#include "../merge.glsl"
#define GNO_MATERIAL_SET 3
#define GNO_TRANSMITTANCE_ADDS 1
#include "../../core/material_bindings.glsl"
#include "../../core/transmittance_sum.glsl"
layout(set = 2, binding = 2, rgba32ui) uniform readonly uimage2D gnoSamples;
layout(set = 2, binding = 3, r32ui) uniform writeonly uimage2D gnoVisibility;

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, GNO_CLUSTER_FRAME.size))) return;
    GnoViewSample s = gnoUnpackViewSample(imageLoad(gnoSamples, ivec2(pixel)));
    uint visibility = s.own == GNO_BACKGROUND ? GNO_VISIBILITY_BACKGROUND : GNO_VISIBILITY_FACING_AWAY;
    if (s.own <= GNO_NO_CASTER) {
        uint at = pixel.y * GNO_CLUSTER_FRAME.size.x + pixel.x;
        visibility = gnoClusterAnswer(pixel, s.position);
        if (visibility == GNO_VISIBILITY_SHADOW) gnoAddOpaque(at);
        if (visibility != GNO_VISIBILITY_UNKNOWN) visibility = gnoIsDark(at) ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT;
    }
    imageStore(gnoVisibility, ivec2(pixel), uvec4(visibility));
}
