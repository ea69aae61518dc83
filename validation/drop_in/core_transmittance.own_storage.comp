#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way C: materials, texels and sums of the user's own; macro bodies use names that a module must not capture.
layout(push_constant) uniform Push { vec4 light; vec4 position; } push;
#include "gnomon/core/material.h"
layout(set = 1, binding = 6, std430) readonly buffer Corners { vec4 corner[]; } corners;
layout(set = 1, binding = 7) uniform sampler2D picture;
layout(set = 1, binding = 8, std430) buffer Sums { uint value[]; } sums;
// Names that a careless module would capture, of types that fit nowhere else: a local of that name inside the module would not compile.
struct Trap { mat4x3 m; };
Trap i, s, p, t, q, a, b, c, light, caster, at, l, m, u, v, w, x, y, texel, surface, material, weights, pixel, channel, high, low, number, digit;
float keep(Trap trap) { return trap.m[0][0]; }
#define TRAPS (keep(i) + keep(s) + keep(p) + keep(t) + keep(q) + keep(a) + keep(b) + keep(c) + keep(light) + keep(caster) + keep(at) + keep(l) + \
               keep(m) + keep(u) + keep(v) + keep(w) + keep(x) + keep(y) + keep(texel) + keep(surface) + keep(material) + keep(weights) + \
               keep(pixel) + keep(channel) + keep(high) + keep(low) + keep(number) + keep(digit))
uint trapped(uint value, float traps) { return traps == 0.0 ? value : value + 1u; }
GnoMaterial ourMaterial(uint which) {
    uint mode = GNO_MATERIAL_MASK | GNO_MATERIAL_LINEAR | (GNO_WRAP_CLAMP << GNO_MATERIAL_WRAP_U) | (GNO_WRAP_MIRRORED << GNO_MATERIAL_WRAP_V);
    ivec2 size = ivec2(256, 128);
    return GnoMaterial(mode, uint(size.x), uint(size.y), which, 65535u, 65535u, 65535u, 65535u, 8355712u, 0u, 0u, 0u);
}
uint ourTexel(uint which) {
    int width = 256;
    return packUnorm4x8(texelFetch(picture, ivec2(int(which) % width, int(which) / width), 0));
}
GnoSurface ourSurface(uint which) {
    vec4 one = corners.corner[3u * which], two = corners.corner[3u * which + 1u], three = corners.corner[3u * which + 2u];
    return GnoSurface(ivec2(256.0 * vec2(one.w)), ivec2(256.0 * vec2(two.w)), ivec2(256.0 * vec2(three.w)), 0u, 0u);
}
#define GNO_LOAD_MATERIAL_OF(which) trapped(which, TRAPS)
#define GNO_LOAD_SURFACE(which) ourSurface(trapped(which, TRAPS))
#define GNO_LOAD_MATERIAL(which) ourMaterial(trapped(which, TRAPS))
#define GNO_LOAD_TEXEL(which) ourTexel(trapped(which, TRAPS))
#define GNO_TRANSMITTANCE_SUMS sums.value
#include "gnomon/core/transmittance.glsl"
#include "gnomon/core/transmittance_sum.glsl"
layout(local_size_x = 64) in;

void main() {
    uint mine = gl_GlobalInvocationID.x;
    GnoCaster triangle = GnoCaster(corners.corner[3u * mine].xyz, corners.corner[3u * mine + 1u].xyz, corners.corner[3u * mine + 2u].xyz);
    if (!gnoIsDark(mine)) gnoAddTransmittance(mine, gnoTransmittance(mine, triangle, push.light, push.position.xyz));
}
