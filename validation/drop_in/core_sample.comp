#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/sample.glsl: snap, turn, make, pack.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/bindings.glsl"
#include "gnomon/core/sample.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    vec3 p = gnoSnapToGrid(push.position.xyz);
    GnoViewSample s = gnoMakeViewSample(p, at, GNO_LOAD_CASTER(at), push.viewer, push.light);
    s = gnoUnpackViewSample(gnoPackViewSample(s));
    result = vec4(s.position + gnoTurnedNormal(GNO_LOAD_CASTER(at), p, push.viewer), float(s.own));
    results.v[at] = result;
}
