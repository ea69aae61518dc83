#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way A: our buffers, our numbers.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_LIGHT push.light
#include "gnomon/core/bindings.glsl"
#define GNO_FOREST_BUILDS GNO_FOREST_PASS_ALLOCATE
#include "gnomon/forest/bindings.glsl"
#define GNO_LIGHT_GRID_BUILDS \
    (GNO_LIGHT_GRID_PASS_RESET | GNO_LIGHT_GRID_PASS_OPEN | GNO_LIGHT_GRID_PASS_SIZES | GNO_LIGHT_GRID_PASS_DEPTH | GNO_LIGHT_GRID_PASS_COUNT | \
     GNO_LIGHT_GRID_PASS_ALLOCATE | GNO_LIGHT_GRID_PASS_EMIT)
#include "gnomon/rivals/light_grid_bindings.glsl"
#include "gnomon/rivals/light_grid_build.glsl"
layout(local_size_x = 64) in;
layout(set = 2, binding = 9, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
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
    results.v[at] = result;
}
