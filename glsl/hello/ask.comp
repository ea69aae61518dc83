#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The smallest question: is this point in shadow? With numbers of its own: everything lies in set 0.
// Compiled three times: HELLO_TOP asks a TOP tree,
// HELLO_FOREST a forest, HELLO_BRUTE_FORCE every caster in turn, by the same exact signs.
layout(local_size_x = 64) in;
struct Hit {
    vec3 position;   // on the grid, on the surface
    uint primitive;  // GNO_BACKGROUND: the ray met nothing
};
layout(push_constant) uniform Frame {
    vec4 light, viewer;
    uint hits, casters;
} frame;
#define GNO_LIGHT frame.light
#define GNO_CORE_SET 0
#define GNO_CORE_BINDING_CASTERS 0
#include "../core/bindings.glsl"
#include "../core/sample.glsl"
layout(set = 0, binding = 1, std430) readonly buffer Hits { Hit v[]; } hits;
layout(set = 0, binding = 2, std430) writeonly buffer Mask { uint v[]; } mask;

#if defined(HELLO_TOP) || defined(HELLO_FOREST)
#define GNO_TOP_SET 0
#define GNO_TOP_BINDING_PLANES 3
#define GNO_TOP_BINDING_LINKS 4
#define GNO_TOP_BINDING_HEADER 5
#ifdef HELLO_FOREST
#define GNO_FOREST_SET 0
#define GNO_FOREST_BINDING_GRID 6
#define GNO_FOREST_BINDING_CELLS 7
#define GNO_FOREST_BINDING_PAIRS 8
#define GNO_FOREST_BINDING_HEADER 9
#define GNO_FOREST_BINDING_FEW 10
#define GNO_FOREST_TREES 1
#include "../forest/bindings.glsl"
#endif
#include "../top/bindings.glsl"
#include "../top/query_hybrid.glsl"
uint answer(GnoViewSample s) { return gnoTopHybridAnswer(s); }
#else
uint answer(GnoViewSample s) {
    for (uint caster = 0u; caster < frame.casters; ++caster)
        if (caster != s.own && gnoInShadowOf(GNO_LIGHT, GNO_LOAD_CASTER(caster), s.position))
            return GNO_VISIBILITY_SHADOW;
    return GNO_VISIBILITY_LIT;
}
#endif

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= frame.hits) return;
    Hit hit = hits.v[i];
    uint visibility = GNO_VISIBILITY_BACKGROUND;
    if (hit.primitive != GNO_BACKGROUND) {
        GnoCaster under = GNO_LOAD_CASTER(hit.primitive);
        GnoViewSample s = gnoMakeViewSample(hit.position, hit.primitive, under, frame.viewer, frame.light);
        visibility = s.own == GNO_FACING_AWAY ? GNO_VISIBILITY_FACING_AWAY : answer(s);
    }
    mask.v[i] = visibility;
}
