#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Pulls casters from their buffer: draw 3 * count vertices, no vertex input.
#include "../bindings.glsl"
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
}
