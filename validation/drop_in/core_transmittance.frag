#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// core/transmittance.glsl with our casters and materials.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/core/bindings.glsl"
#include "gnomon/core/material_bindings.glsl"
#include "gnomon/core/transmittance.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    uvec3 add = gnoIsOpaqueCaster(at) ? uvec3(0u) : gnoTransmittance(at, GNO_LOAD_CASTER(at), push.light, push.position.xyz);
    GnoMaterial m = GNO_LOAD_MATERIAL(push.count);
    uvec4 texel = gnoSampleTexture(m, gnoHitTexel(uvec3(1u), GNO_LOAD_SURFACE(at)));
    result = vec4(vec3(add) + vec3(gnoTransmitted(m, texel)), float(gnoContribution(texel.w)));
}
