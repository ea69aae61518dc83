#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Several lights in one shader: the forests of each lie one behind the other in the same buffers, and the light that is asked about is a variable.
// The device test of it runs this shader.
#include "gnomon/forest/cells.h"
struct Light {
    vec4 place;
    GnoForestGrid grid;
    uint firstNode;
    uint firstHeader;
    uint firstCell;
    uint firstPair;
};
layout(set = 2, binding = 7, std140) uniform Lights {
    vec4 viewer;
    uint count;
    Light v[8];
}
lights;
layout(set = 2, binding = 8, std430) readonly buffer Points { uvec4 v[]; } points;  // bits of a position on the grid, primitive
Light light;
#define GNO_LIGHT light.place
#define GNO_FOREST_TREES 1
#define GNO_FOREST_GRID light.grid
#define GNO_FOREST_FIRST_CELL light.firstCell
#define GNO_FOREST_FIRST_PAIR light.firstPair
#define GNO_TOP_FIRST_NODE light.firstNode
#define GNO_TOP_FIRST_HEADER light.firstHeader
#include "gnomon/core/bindings.glsl"
#include "gnomon/core/sample.glsl"
#include "gnomon/forest/bindings.glsl"
#include "gnomon/top/bindings.glsl"
#include "gnomon/top/query_hybrid.glsl"
layout(local_size_x = 64) in;
layout(set = 2, binding = 9, std430) writeonly buffer Results { uint v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    uint found = 0u;
    if (at < uint(points.v.length()) && points.v[at].w != GNO_BACKGROUND) {
        uint primitive = points.v[at].w;
        for (uint i = 0u; i < lights.count; ++i) {
            light = lights.v[i];
            GnoCaster under = GNO_LOAD_CASTER(primitive);
            GnoViewSample s = gnoMakeViewSample(uintBitsToFloat(points.v[at].xyz), primitive, under, lights.viewer, light.place);
            uint visibility = s.own == GNO_FACING_AWAY ? GNO_VISIBILITY_FACING_AWAY : gnoTopHybridAnswer(s);
            found |= visibility << (4u * i);
        }
    }
    results.v[at] = found;
}
