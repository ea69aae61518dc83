#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way B: our buffers, other sets and bindings.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_SHADOW_MAP_SET 2
#define GNO_SHADOW_MAP_BINDING_VIEWS 20
#define GNO_SHADOW_MAP_BINDING_BOUNDS 21
#define GNO_LIGHT push.light
#define GNO_SHADOW_MAP_MEASURES 1
#include "gnomon/shadow_map/bindings.glsl"
#include "gnomon/shadow_map/fit.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    gnoShadowMapMeasure(GnoViewSample(push.position.xyz, at));
    result = gnoShadowMapFit(uvec4(GNO_SHADOW_MAP_BOUNDS[0], GNO_SHADOW_MAP_BOUNDS[1], GNO_SHADOW_MAP_BOUNDS[2], GNO_SHADOW_MAP_BOUNDS[3]),
                             vec4(-1.0, 1.0, -1.0, 1.0));
    results.v[at] = result;
}
