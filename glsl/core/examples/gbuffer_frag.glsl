// SPDX-License-Identifier: MIT
// Position, geometric normal turned to the viewer, primitive. Attachments: RGBA32F, RGBA32F, R32_UINT. What a camera does not see is left out: back
// faces of one-sided casters, and with GNO_EXAMPLE_MATERIALS 1 the holes of those that are not opaque (coverage 0). They cast as ever.
#include "../bindings.glsl"
#include "../sample.glsl"
#include "frame.glsl"
#if GNO_EXAMPLE_MATERIALS
#define GNO_MATERIAL_SET 3
#define GNO_MATERIAL_SUMS 0
#include "../material_bindings.glsl"
#include "../transmittance.glsl"
layout(location = 2) in vec2 gnoTexel;
layout(location = 3) flat in uint gnoMaterialNumber;
#endif
layout(set = 2, binding = 18, std430) readonly buffer GnoExampleOneSided { uint v[]; } gnoOneSided;  // a bit a caster, 32 a word
layout(location = 0) in vec3 gnoPosition;
layout(location = 1) flat in uint gnoPrimitive;
layout(location = 0) out vec4 gnoPositionOut;
layout(location = 1) out vec4 gnoNormalOut;
layout(location = 2) out uint gnoPrimitiveOut;

void main() {
    GnoCaster t = GNO_LOAD_CASTER(gnoPrimitive);
    vec3 normal = gnoTurnedNormal(t, gnoPosition, gnoPush.viewer);
    bool oneSided = ((gnoOneSided.v[gnoPrimitive >> 5u] >> (gnoPrimitive & 31u)) & 1u) != 0u;
    if (oneSided && dot(normal, gnoExactNormal(t)) < 0.0) discard;  // turned: its back
#if GNO_EXAMPLE_MATERIALS
    if (gnoMaterialNumber != GNO_OPAQUE_CASTER) {
        GnoMaterial m = GNO_LOAD_MATERIAL(gnoMaterialNumber);
        if (gnoCoverage(m, gnoSampleTexture(m, ivec2(floor(gnoTexel)))) == 0u) discard;
    }
#endif
    gnoPositionOut = vec4(gnoPosition, 1.0);
    gnoNormalOut = vec4(normal, 0.0);
    gnoPrimitiveOut = gnoPrimitive;
}
