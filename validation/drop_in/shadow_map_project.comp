#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/shadow_map/bindings.glsl"
#include "gnomon/shadow_map/project.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    GnoShadowMapView view = GNO_SHADOW_MAP_LOAD_VIEW(at);
    vec4 clip = gnoShadowMapClip(view, push.position.xyz);
    bool drawn = gnoShadowMapDraws(push.seed, GNO_SHADOW_MAP_BACK);
    result = drawn && gnoShadowMapHolds(clip) ? vec4(gnoShadowMapTexel(clip, GNO_SHADOW_MAP_SIZE), gnoShadowMapDepth(view, clip), 1.0) : clip;
    results.v[at] = result;
}
