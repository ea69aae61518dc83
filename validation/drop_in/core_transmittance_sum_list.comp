#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Every caster against every sample, one pair an invocation, in an order that a seed decides: a test adds up a whole scene with it.
layout(push_constant) uniform Push { vec4 light; uint casters; uint samples; uint seed; } push;
#include "gnomon/core/bindings.glsl"
#define GNO_TRANSMITTANCE_ADDS 1
#include "gnomon/core/material_bindings.glsl"
#include "gnomon/core/orient3d.glsl"
#include "gnomon/core/permutation.glsl"
#include "gnomon/core/transmittance.glsl"
#include "gnomon/core/transmittance_sum.glsl"
layout(set = 1, binding = 0, std430) readonly buffer Samples { uvec4 v[]; } samples;  // position bits, own
layout(local_size_x = 64) in;

void main() {
    uint number = gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * 64u;
    if (number >= push.casters * push.samples) return;
    uint pair = gnoPermute(number, push.casters * push.samples, push.seed);
    uint caster = pair % push.casters;
    uint pixel = pair / push.casters;
    uvec4 s = samples.v[pixel];
    if (s.w == caster || gnoIsDark(pixel)) return;
    GnoCaster t = GNO_LOAD_CASTER(caster);
    vec3 p = uintBitsToFloat(s.xyz);
    if (!gnoInShadowOf(push.light, t, p)) return;
    if (gnoIsOpaqueCaster(caster)) gnoAddOpaque(pixel);
    else gnoAddTransmittance(pixel, gnoTransmittance(caster, t, push.light, p));
}
