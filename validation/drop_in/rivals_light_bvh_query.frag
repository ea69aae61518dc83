#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#include "gnomon/core/bindings.glsl"
#include "gnomon/rivals/light_bvh_bindings.glsl"
#include "gnomon/rivals/light_bvh_query.glsl"
layout(location = 0) out vec4 result;

void main() {
    GnoViewSample s = GnoViewSample(push.position.xyz, push.seed);
    result = vec4(gnoLightBvhQuery(s) ? 1.0 : 0.0, gnoLightBvhQueryStackless(s) ? 1.0 : 0.0, 0.0, 0.0);
}
