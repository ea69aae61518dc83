#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way C: everything inside one buffer of the engine's; macro bodies use names that a module must not capture.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/forest/cells.h"
#include "gnomon/rivals/light_bvh.h"
layout(set = 1, binding = 7, std430) readonly buffer Hierarchy {
    GnoLightBvhHeader header;
    GnoForestGrid grid;
    GnoLightBvhNode nodes[64];
    uint parents[64];
}
hierarchy;
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
#define GNO_LOAD_CASTER(number_) engineCaster(trapped(number_, TRAPS))
#define GNO_LIGHT_BVH_GRID hierarchy.grid
#define GNO_LIGHT_BVH_STATE trapped(hierarchy.header.state, TRAPS)
#define GNO_LIGHT_BVH_ROOT(face_) hierarchy.header.roots[trapped(face_, TRAPS)]
#define GNO_LIGHT_BVH_LOAD_NODE(number_) hierarchy.nodes[trapped(number_, TRAPS)]
#define GNO_LIGHT_BVH_LOAD_PARENT(number_) hierarchy.parents[trapped(number_, TRAPS)]
#include "gnomon/rivals/light_bvh_query.glsl"
layout(local_size_x = 64) in;
layout(set = 2, binding = 9, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    vec4 result;
    GnoViewSample asked = GnoViewSample(push.position.xyz, push.seed);
    result = vec4(gnoLightBvhQuery(asked) ? 1.0 : 0.0, gnoLightBvhQueryStackless(asked) ? 1.0 : 0.0, 0.0, 0.0);
    results.v[gl_GlobalInvocationID.x] = result;
}
