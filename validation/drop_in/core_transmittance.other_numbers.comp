#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way B: our buffers, numbers of the user's own.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_MATERIAL_SET 2
#define GNO_MATERIAL_BINDING_OF 7
#define GNO_MATERIAL_BINDING_SURFACES 9
#define GNO_MATERIAL_BINDING_LIST 8
#define GNO_MATERIAL_BINDING_TEXELS 5
#define GNO_MATERIAL_BINDING_SUMS 11
#include "gnomon/core/bindings.glsl"
#define GNO_TRANSMITTANCE_ADDS 1
#include "gnomon/core/material_bindings.glsl"
#include "gnomon/core/transmittance.glsl"
#include "gnomon/core/transmittance_sum.glsl"
layout(local_size_x = 64) in;

void main() {
    uint at = gl_GlobalInvocationID.x;
    gnoAddTransmittance(at, gnoTransmittance(at, GNO_LOAD_CASTER(at), push.light, push.position.xyz));
}
