#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/transmittance.glsl with our casters and materials.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/bindings.glsl"
#include "gnomon/core/material_bindings.glsl"
#include "gnomon/core/transmittance.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    uvec3 add = gnoIsOpaqueCaster(at) ? uvec3(0u) : gnoTransmittance(at, GNO_LOAD_CASTER(at), push.light, push.position.xyz);
    GnoMaterial m = GNO_LOAD_MATERIAL(push.count);
    uvec4 texel = gnoSampleTexture(m, gnoHitTexel(uvec3(1u), GNO_LOAD_SURFACE(at)));
    result = vec4(vec3(add) + vec3(gnoTransmitted(m, texel)), float(gnoContribution(texel.w)));
    results.v[at] = result;
}
