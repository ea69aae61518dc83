#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#include "gnomon/core/bindings.glsl"
#include "gnomon/forest/bindings.glsl"
#include "gnomon/rivals/light_grid_bindings.glsl"
#include "gnomon/rivals/light_grid_build.glsl"
layout(location = 0) out vec4 colour;

void main() {
    uint at = uint(gl_FragCoord.x);
    vec4 result;
    GnoCaster t = GNO_LOAD_CASTER(at);
    gnoLightGridReset();
    gnoLightGridOpen(at);
    gnoLightGridSizes();
    gnoLightGridSeeSample(push.position.xyz);
    gnoLightGridCount(at, t, 1);
    gnoLightGridAllocate(at);
    gnoLightGridEmit(at, push.seed, t, 1);
    result = vec4(0.0);
    colour = result;
}
