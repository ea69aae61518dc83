#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way C: everything inside one buffer of the engine's; macro bodies use names that a module must not capture.
layout(push_constant) uniform Push { vec4 light; vec4 position; uint count; uint seed; } push;
#include "gnomon/forest/cells.h"
#include "gnomon/rivals/light_bvh.h"
layout(set = 1, binding = 7, std430) buffer Hierarchy {
    GnoLightBvhHeader header;
    GnoForestGrid grid;
    GnoLightBvhLevel levels[GNO_LIGHT_BVH_LEVELS];
    GnoLightBvhBox references[64];
    GnoLightBvhBox boxes[128];
    GnoLightBvhBox splits[64];
    GnoLightBvhNode nodes[64];
    uint masks[64], sums[64], keys[64], order[64], parents[64];
} hierarchy;
layout(set = 1, binding = 6, std430) readonly buffer Corners { vec4 corner[]; } corners;
// Names that a careless module would capture, of types that fit nowhere else: a local of that name inside the module would not compile.
struct Trap { mat4x3 m; };
Trap caster, faces, group, invocation, total, held, references, face, level, at, c, low, high, least, i, row, below, boxes, r, first, box, j, end,
    last, key, other, count, stands, node, n, before, after, way, outside, step, length, inside, reach, split, children, widest, area, its, inner,
    taken, next, made, t, v, q, x, y, z, light, grid, cells, whole, bit, digit, width, a, b, both, place, s, depth, index, from, met, down, child,
    link, parent, stack, used, lost, leaf, p;
float keep(Trap trap) { return trap.m[0][0]; }
#define TRAPS                                                                                                                                    \
    (keep(caster) + keep(faces) + keep(group) + keep(invocation) + keep(total) + keep(held) + keep(references) + keep(face) + keep(level) +      \
     keep(at) + keep(c) + keep(low) + keep(high) + keep(least) + keep(i) + keep(row) + keep(below) + keep(boxes) + keep(r) + keep(first) +       \
     keep(box) + keep(j) + keep(end) + keep(last) + keep(key) + keep(other) + keep(count) + keep(stands) + keep(node) + keep(n) + keep(before) + \
     keep(after) + keep(way) + keep(outside) + keep(step) + keep(length) + keep(inside) + keep(reach) + keep(split) + keep(children) +           \
     keep(widest) + keep(area) + keep(its) + keep(inner) + keep(taken) + keep(next) + keep(made) + keep(t) + keep(v) + keep(q) + keep(x) +       \
     keep(y) + keep(z) + keep(light) + keep(grid) + keep(cells) + keep(whole) + keep(bit) + keep(digit) + keep(width) + keep(a) + keep(b) +      \
     keep(both) + keep(place) + keep(s) + keep(depth) + keep(index) + keep(from) + keep(met) + keep(down) + keep(child) + keep(link) +           \
     keep(parent) + keep(stack) + keep(used) + keep(lost) + keep(leaf) + keep(p))
uint trapped(uint number, float traps) { return traps == 0.0 ? number : number + 1u; }
GnoCaster engineCaster(uint number) {
    return GnoCaster(corners.corner[3u * number].xyz, corners.corner[3u * number + 1u].xyz, corners.corner[3u * number + 2u].xyz);
}
vec4 engineLight(float traps) { return push.light + vec4(traps); }
#define GNO_LIGHT engineLight(TRAPS)
#define GNO_LIGHT_BVH_GRID hierarchy.grid
#define GNO_LIGHT_BVH_MASKS hierarchy.masks
#define GNO_LIGHT_BVH_SUMS hierarchy.sums
#define GNO_LIGHT_BVH_HEADER hierarchy.header
#define GNO_LIGHT_BVH_LEVEL_TABLE hierarchy.levels
#define GNO_LIGHT_BVH_REFERENCES hierarchy.references
#define GNO_LIGHT_BVH_CAPACITY trapped(64u, TRAPS)
#define GNO_LIGHT_BVH_KEYS hierarchy.keys
#define GNO_LIGHT_BVH_ORDER hierarchy.order
#define GNO_LIGHT_BVH_BOXES hierarchy.boxes
#define GNO_LIGHT_BVH_SPLITS hierarchy.splits
#define GNO_LIGHT_BVH_NODES hierarchy.nodes
#define GNO_LIGHT_BVH_PARENTS hierarchy.parents
#include "gnomon/rivals/light_bvh_build.glsl"
layout(local_size_x = 64) in;

void main() {
    uint number = gl_GlobalInvocationID.x;
    GnoLightBvhCaster seen = gnoLightBvhCaster(push.light, engineCaster(number), 1);
    uint mask = gnoLightBvhFaces(push.light, hierarchy.grid, seen);
    gnoLightBvhCount(number, mask, gl_WorkGroupID.x, gl_LocalInvocationIndex);
    gnoLightBvhBegin(push.count);
    gnoLightBvhEmit(number, mask, seen, gnoLightBvhFirst(mask, gl_WorkGroupID.x, gl_LocalInvocationIndex));
    gnoLightBvhLeaf(number);
    gnoLightBvhUp(push.seed, number);
    gnoLightBvhSplit(number);
    gnoLightBvhCollapse(push.seed, number);
}
