#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/orient3d.glsl with our casters.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/bindings.glsl"
#include "gnomon/core/orient3d.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    GnoCaster t = GNO_LOAD_CASTER(at);
    bool inShadow =
        gnoInShadowOf(push.light, t, push.position.xyz) || gnoInShadowOfFacing(push.light, t, push.position.xyz, gnoFacing(push.light, t));
    result = vec4(gnoExactNormal(t), float(gnoOrient3d(t.a, t.b, t.c, push.position.xyz) + gnoOrient3dLight(push.light, t.a, t.b, t.c)));
    if (inShadow) result = -result;
    results.v[at] = result;
}
