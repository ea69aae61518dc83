#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/orient3d.glsl without its filter, and with a count of the exact signs.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/bindings.glsl"
uint exactSigns = 0u;
#define GNO_ORIENT3D_FILTER 0
#define GNO_ORIENT3D_ON_EXACT ++exactSigns
#include "gnomon/core/orient3d.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    result = vec4(float(gnoFacing(push.light, GNO_LOAD_CASTER(at))));
    result.w = float(exactSigns);
    results.v[at] = result;
}
