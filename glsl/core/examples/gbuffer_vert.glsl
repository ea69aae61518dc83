// SPDX-License-Identifier: MIT
// Pulls casters from their buffer: draw 3 * count vertices, no vertex input. GNO_EXAMPLE_MATERIALS 1: texel coordinates of casters that are not
// opaque as well.
#include "../bindings.glsl"
#if GNO_EXAMPLE_MATERIALS
#define GNO_MATERIAL_SET 3
#define GNO_MATERIAL_SUMS 0
#include "../material_bindings.glsl"
layout(location = 2) out vec2 gnoTexel;
layout(location = 3) flat out uint gnoMaterialNumber;  // GNO_OPAQUE_CASTER: none
#endif
layout(set = 2, binding = 14, std140) uniform GnoExampleCamera { mat4 clipFromGrid; } gnoCamera;
layout(location = 0) out vec3 gnoPosition;
layout(location = 1) flat out uint gnoPrimitive;

void main() {
    uint caster = uint(gl_VertexIndex) / 3u;
    uint corner = uint(gl_VertexIndex) - 3u * caster;
    GnoCaster t = GNO_LOAD_CASTER(caster);
    gnoPosition = corner == 0u ? t.a : corner == 1u ? t.b : t.c;
    gnoPrimitive = caster;
    gl_Position = gnoCamera.clipFromGrid * vec4(gnoPosition, 1.0);
#if GNO_EXAMPLE_MATERIALS
    uint number = GNO_LOAD_MATERIAL_OF(caster);
    gnoTexel = vec2(0.0);
    gnoMaterialNumber = GNO_OPAQUE_CASTER;
    if (number != GNO_OPAQUE_CASTER) {
        GnoSurface s = GNO_LOAD_SURFACE(number);
        gnoTexel = vec2(corner == 0u ? s.a : corner == 1u ? s.b : s.c);
        gnoMaterialNumber = s.material;
    }
#endif
}
