#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way C: all arrays inside one buffer of the engine's; macro bodies use names that a module must not capture.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/clusters/cluster.h"
#include "gnomon/core/light.glsl"
layout(set = 1, binding = 6, std430) readonly buffer Corners { vec4 corner[]; } corners;
layout(set = 1, binding = 7, std430) coherent buffer Engine {
    GnoClusterFrame frame;
    GnoClusterLayout tree;
    GnoClusterHeader header;
    float slices[1025];
    uint masks[8192];
    uint shade[4096];
    float lows[98304];
    float highs[98304];
    uvec2 pointers[8192];
    vec4 volumes[7168];
    uvec2 infos[1024];
    uvec2 jobs[1024];
} engine;
// Names that a careless module would capture, of types that fit nowhere else: a local of that name inside the module would not compile.
struct Trap { mat4x3 m; };
Trap node, i, s, index, p, t, q, a, b, c, light, point, side, caster, first, next, stack, used, depth, plane, link, at, root, own, l, n, x, y, z,
    key, tile, pixel, word, mask, box, low, high, child, slot, job, slice, volume, bounds, margin, range, dark, found, count, levels, pending, split,
    start, alive, accepted, inside;
float keep(Trap trap) { return trap.m[0][0]; }
#define TRAPS (keep(node) + keep(i) + keep(s) + keep(index) + keep(p) + keep(t) + keep(q) + keep(a) + keep(b) + keep(c) + keep(light) + \
               keep(point) + keep(side) + keep(caster) + keep(first) + keep(next) + keep(stack) + keep(used) + keep(depth) + keep(plane) + \
               keep(link) + keep(at) + keep(root) + keep(own) + keep(l) + keep(n) + keep(x) + keep(y) + keep(z) + keep(key) + keep(tile) + \
               keep(pixel) + keep(word) + keep(mask) + keep(box) + keep(low) + keep(high) + keep(child) + keep(slot) + keep(job) + \
               keep(slice) + keep(volume) + keep(bounds) + keep(margin) + keep(range) + keep(dark) + keep(found) + keep(count) + \
               keep(levels) + keep(pending) + keep(split) + keep(start) + keep(alive) + keep(accepted) + keep(inside))
uint trapped(uint number, float traps) { return traps == 0.0 ? number : number + 1u; }
GnoClusterFrame engineFrame(float traps) { return engine.frame; }
GnoClusterLayout engineTree(float traps) { return engine.tree; }
#define GNO_CLUSTER_FRAME engineFrame(TRAPS)
#define GNO_CLUSTER_LAYOUT engineTree(TRAPS)
#define GNO_CLUSTER_FORM trapped(engine.tree.form, TRAPS)
#define GNO_CLUSTER_HEADER engine.header
#define GNO_CLUSTER_VOLUMES engine.volumes
#define GNO_CLUSTER_INFO engine.infos
GnoCaster engineCaster(uint number) {
    return GnoCaster(corners.corner[3u * number].xyz, corners.corner[3u * number + 1u].xyz, corners.corner[3u * number + 2u].xyz);
}
vec4 engineLight(float traps) { return push.light + vec4(traps); }
#define GNO_LIGHT engineLight(TRAPS)
#define GNO_LOAD_CASTER(number) engineCaster(trapped(number, TRAPS))
#define GNO_PRECISION trapped(2u, TRAPS)
#include "gnomon/clusters/volume.glsl"
layout(local_size_x = 64) in;

void main() {
    uint number = gl_GlobalInvocationID.x;
    if (number < push.count) gnoClusterSetUpVolume(number, int(push.seed) - 1);
}
