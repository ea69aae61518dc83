#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way C: everything inside one buffer of the engine's; macro bodies use names that a module must not capture.
layout(push_constant) uniform Push { vec4 light; vec4 position; uint count; uint seed; } push;
#include "gnomon/forest/cells.h"
layout(set = 1, binding = 6, std430) readonly buffer Corners { vec4 corner[]; } corners;
layout(set = 1, binding = 7, std430) buffer Forest {
    GnoForestHeader header;
    GnoForestGrid grid;
    GnoForestCell cells[4096];
    GnoForestFew few[4096];
    GnoForestPair pairs[4096];
}
forest;
// Names that a careless module would capture, of types that fit nowhere else: a local of that name inside the module would not compile.
struct Trap { mat4x3 m; };
Trap cell, i, s, at, p, t, q, v, a, b, c, n, r, x, y, z, light, face, caster, least, most, depth, plane, grid, count, slot, span, lane, lanes, width,
    height, step, place, few, kept, seen, size, wide;
float keep(Trap trap) { return trap.m[0][0]; }
#define TRAPS                                                                                                                                    \
    (keep(cell) + keep(i) + keep(s) + keep(at) + keep(p) + keep(t) + keep(q) + keep(v) + keep(a) + keep(b) + keep(c) + keep(n) + keep(r) +       \
     keep(x) + keep(y) + keep(z) + keep(light) + keep(face) + keep(caster) + keep(least) + keep(most) + keep(depth) + keep(plane) + keep(grid) + \
     keep(count) + keep(slot) + keep(span) + keep(lane) + keep(lanes) + keep(width) + keep(height) + keep(step) + keep(place) + keep(few) +      \
     keep(kept) + keep(seen) + keep(size) + keep(wide))
uint trapped(uint number, float traps) { return traps == 0.0 ? number : number + 1u; }
GnoCaster engineCaster(uint number) {
    return GnoCaster(corners.corner[3u * number].xyz, corners.corner[3u * number + 1u].xyz, corners.corner[3u * number + 2u].xyz);
}
vec4 engineLight(float traps) { return push.light + vec4(traps); }
#define GNO_LIGHT engineLight(TRAPS)
#define GNO_FOREST_GRID forest.grid
#define GNO_FOREST_CELLS forest.cells
#define GNO_FOREST_FEW forest.few
#define GNO_FOREST_PAIRS forest.pairs
#define GNO_FOREST_CAPACITY trapped(4096u, TRAPS)
#define GNO_FOREST_HEADER forest.header
#include "gnomon/forest/assign.glsl"
layout(local_size_x = 64) in;

void main() {
    uint number = gl_GlobalInvocationID.x;
    if (number >= push.count) return;
    GnoCellVolume volume = gnoCellVolume(push.light, engineCaster(number), 1);
    GnoForestSeen farthest = gnoForestSeen();
    gnoForestSeeSample(farthest, push.position.xyz);
    gnoForestTell(farthest);
    gnoForestNone(number);
    uint size = gnoForestSort(number, gnoCellSight(push.light, engineCaster(number)));
    gnoForestCover(volume, 0u, 1u);
    gnoForestCountFew(number);
    gnoForestCount(volume, 0u, 1u);
    gnoForestAllocate(number);
    gnoForestEmitFew(number);
    gnoForestEmit(number, volume, size, 1u);
    gnoForestSizes();
}
