#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way B: our buffers, other sets and bindings.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#define GNO_FOREST_SET 1
#define GNO_FOREST_BINDING_GRID 20
#define GNO_FOREST_BINDING_CELLS 21
#define GNO_FOREST_BINDING_PAIRS 22
#define GNO_FOREST_BINDING_HEADER 23
#define GNO_FOREST_BINDING_FEW 24
#define GNO_LIGHT_GRID_SET 2
#define GNO_LIGHT_GRID_BINDING_LISTS 10
#define GNO_LIGHT_GRID_BINDING_ITEMS 11
#define GNO_LIGHT_GRID_BINDING_DEPTHS 12
#define GNO_LIGHT_GRID_BINDING_HEADER 13
#define GNO_LIGHT_GRID_BINDING_PLANES 14
#define GNO_LIGHT_GRID_NEST push.seed
#define GNO_LIGHT push.light
#include "gnomon/core/bindings.glsl"
#define GNO_FOREST_BUILDS 1
#include "gnomon/forest/bindings.glsl"
#define GNO_LIGHT_GRID_BUILDS 1
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
