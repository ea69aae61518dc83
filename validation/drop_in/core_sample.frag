#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/sample.glsl: snap, turn, make, pack.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/bindings.glsl"
#include "gnomon/core/sample.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    vec3 p = gnoSnapToGrid(push.position.xyz);
    GnoViewSample s = gnoMakeViewSample(p, at, GNO_LOAD_CASTER(at), push.viewer, push.light);
    s = gnoUnpackViewSample(gnoPackViewSample(s));
    result = vec4(s.position + gnoTurnedNormal(GNO_LOAD_CASTER(at), p, push.viewer), float(s.own));
}
