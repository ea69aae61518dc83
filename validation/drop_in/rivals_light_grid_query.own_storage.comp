#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way C: everything inside buffers of the engine's; macro bodies use names that a module must not capture.
layout(push_constant) uniform Push { vec4 light; vec4 position; uint count; uint seed; } push;
#include "gnomon/forest/cells.h"
#include "gnomon/rivals/light_grid.h"
layout(set = 1, binding = 6, std430) readonly buffer Corners { vec4 corner[]; } corners;
layout(set = 1, binding = 7, std430) readonly buffer Forest {
    GnoForestHeader header;
    GnoForestGrid grid;
    GnoForestCell cells[4096];
    GnoForestPair pairs[4096];
    GnoForestFew few[4096];
}
forest;
layout(set = 1, binding = 8, std430) readonly buffer Lists {
    GnoLightGridHeader header;
    GnoLightGridList lists[8192];
    uint depths[4096];
    GnoLightGridItem items[4096];
}
ours;
// Names that a careless module would capture, of types that fit nowhere else: a local of that name inside the module would not compile.
struct Trap { mat4x3 m; };
Trap cell, i, s, at, p, t, q, v, a, b, c, n, r, x, y, z, light, face, caster, least, most, depth, plane, planes, grid, fine, count, slot, span, lane,
    group, list, item, first, end, place, nest, pairs, groups, farthest, facing, own, band, cap, size, apart, low, high, from, to, width, middle,
    base;
float keep(Trap trap) { return trap.m[0][0]; }
#define TRAPS                                                                                                                                      \
    (keep(cell) + keep(i) + keep(s) + keep(at) + keep(p) + keep(t) + keep(q) + keep(v) + keep(a) + keep(b) + keep(c) + keep(n) + keep(r) +         \
     keep(x) + keep(y) + keep(z) + keep(light) + keep(face) + keep(caster) + keep(least) + keep(most) + keep(depth) + keep(plane) + keep(planes) + \
     keep(grid) + keep(fine) + keep(count) + keep(slot) + keep(span) + keep(lane) + keep(group) + keep(list) + keep(item) + keep(first) +          \
     keep(end) + keep(place) + keep(nest) + keep(pairs) + keep(groups) + keep(farthest) + keep(facing) + keep(own) + keep(band) + keep(cap) +      \
     keep(size) + keep(apart) + keep(low) + keep(high) + keep(from) + keep(to) + keep(width) + keep(middle) + keep(base))
uint trapped(uint number, float traps) { return traps == 0.0 ? number : number + 1u; }
GnoCaster engineCaster(uint number, float traps) {
    return GnoCaster(corners.corner[3u * number].xyz + vec3(traps), corners.corner[3u * number + 1u].xyz, corners.corner[3u * number + 2u].xyz);
}
vec4 engineLight(float traps) { return push.light + vec4(traps); }
#define GNO_LIGHT engineLight(TRAPS)
#define GNO_FOREST_GRID forest.grid
#define GNO_LOAD_CASTER(number_) engineCaster(number_, TRAPS)
#define GNO_LIGHT_GRID_STATE trapped(gnoLightGridState(ours.header, true), TRAPS)
#define GNO_LIGHT_GRID_LISTS ours.lists
#define GNO_LIGHT_GRID_ITEMS ours.items
#define GNO_LIGHT_GRID_PLANES 1
#define GNO_LIGHT_GRID_LOAD_PLANE(number_) corners.corner[trapped(number_, TRAPS)]
#include "gnomon/rivals/light_grid_query.glsl"
layout(local_size_x = 64) in;
layout(set = 2, binding = 9, std430) writeonly buffer Results { uint v[]; } results;

void main() { results.v[gl_GlobalInvocationID.x] = uint(gnoLightGridAnswer(GnoViewSample(push.position.xyz, push.seed))); }
