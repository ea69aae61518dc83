#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/orient3d.glsl with our casters.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/bindings.glsl"
#include "gnomon/core/orient3d.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    GnoCaster t = GNO_LOAD_CASTER(at);
    bool inShadow =
        gnoInShadowOf(push.light, t, push.position.xyz) || gnoInShadowOfFacing(push.light, t, push.position.xyz, gnoFacing(push.light, t));
    result = vec4(gnoExactNormal(t), float(gnoOrient3d(t.a, t.b, t.c, push.position.xyz) + gnoOrient3dLight(push.light, t.a, t.b, t.c)));
    if (inShadow) result = -result;
}
