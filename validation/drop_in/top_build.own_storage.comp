#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way C: planes, links and header inside one buffer of the engine's; macro bodies use names that a module must not capture.
layout(push_constant) uniform Push { vec4 light; uint count; uint seed; } push;
#include "gnomon/top/node.h"
layout(set = 1, binding = 6, std430) readonly buffer Corners { vec4 corner[]; } corners;
layout(set = 1, binding = 7, std430) coherent buffer Tree {
    GnoTopHeader header;
    vec4 planes[4096];
    GnoTopLink links[4096];
    GnoTopSlab slabs[4096];
}
tree;
// Names that a careless module would capture, of types that fit nowhere else: a local of that name inside the module would not compile.
struct Trap { mat4x3 m; };
Trap node, i, s, index, p, t, q, a, b, c, light, point, side, caster, first, next, stack, used, depth, plane, link, at, root, own, l, n, x, y, z;
float keep(Trap trap) { return trap.m[0][0]; }
#define TRAPS                                                                                                                               \
    (keep(node) + keep(i) + keep(s) + keep(index) + keep(p) + keep(t) + keep(q) + keep(a) + keep(b) + keep(c) + keep(light) + keep(point) + \
     keep(side) + keep(caster) + keep(first) + keep(next) + keep(stack) + keep(used) + keep(depth) + keep(plane) + keep(link) + keep(at) +  \
     keep(root) + keep(own) + keep(l) + keep(n) + keep(x) + keep(y) + keep(z))
uint trapped(uint number, float traps) { return traps == 0.0 ? number : number + 1u; }
GnoCaster engineCaster(uint number) {
    return GnoCaster(corners.corner[3u * number].xyz, corners.corner[3u * number + 1u].xyz, corners.corner[3u * number + 2u].xyz);
}
vec4 engineLight(float traps) { return push.light + vec4(traps); }
#define GNO_TOP_PLANES tree.planes
#define GNO_TOP_LINKS tree.links
#define GNO_TOP_HEADER tree.header
#define GNO_TOP_SLABS tree.slabs
#define GNO_TOP_SLAB trapped(1u, TRAPS)
#define GNO_LIGHT engineLight(TRAPS)
#define GNO_LOAD_CASTER(number) engineCaster(trapped(number, TRAPS))
#define GNO_PRECISION trapped(2u, TRAPS)
#include "gnomon/top/build.glsl"
#include "gnomon/core/orient3d.glsl"
layout(local_size_x = 64) in;

void main() {
    uint number = gl_GlobalInvocationID.x;
    if (number >= push.count) return;
    if (push.seed == 0u) gnoTopSetUp(number, gnoFacing(push.light, engineCaster(number)));
    else gnoTopInsert(number);
}
