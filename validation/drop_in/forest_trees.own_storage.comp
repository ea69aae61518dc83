#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way C: the trees of a forest in the engine's own storage; macro bodies use names that a module must not capture.
layout(push_constant) uniform Push { vec4 light; vec4 position; uint count; uint seed; } push;
#include "gnomon/forest/cells.glsl"
#include "gnomon/top/node.h"
layout(set = 1, binding = 6, std430) readonly buffer Corners { vec4 corner[]; } corners;
layout(set = 1, binding = 7, std430) coherent buffer Forest {
    GnoForestGrid grid;
    GnoTopHeader trees;
    uvec2 standsIn[4096];
    uint roots[4096];
    vec4 planes[16384];
    GnoTopLink links[16384];
}
forest;
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
GnoTopNode engineNode(uint number) {
    return GnoTopNode(forest.planes[number], forest.links[number].positiveChild, forest.links[number].intersectionChild, forest.links[number].aux,
                      forest.links[number].wedge);
}
uint engineRoot(vec3 seen, float traps) { return trapped(forest.roots[gnoCellOf(push.light, forest.grid, seen)], traps); }
#define GNO_TOP_PLANES forest.planes
#define GNO_TOP_LINKS forest.links
#define GNO_TOP_HEADER forest.trees
#define GNO_TOP_STATE trapped(gnoTopState(forest.trees), TRAPS)
#define GNO_TOP_ROOT_OF(number) forest.roots[trapped(forest.standsIn[number].y, TRAPS)]
#define GNO_TOP_CASTER_OF(number) forest.standsIn[trapped(number, TRAPS)].x
#define GNO_TOP_FIND_ROOT(seen) engineRoot(seen, TRAPS)
#define GNO_TOP_LOAD_NODE(number) engineNode(trapped(number, TRAPS))
#define GNO_TOP_LOAD_ANCESTOR(number) forest.links[trapped(4u * ((number) / 4u) + 1u, TRAPS)].aux
#define GNO_TOP_LOAD_FLAGS(number) forest.links[trapped(4u * ((number) / 4u) + 2u, TRAPS)].aux
#define GNO_LIGHT engineLight(TRAPS)
#define GNO_LOAD_CASTER(number) engineCaster(trapped(number, TRAPS))
#include "gnomon/top/build.glsl"
#include "gnomon/top/query_hybrid.glsl"
#include "gnomon/top/query_stack.glsl"
#include "gnomon/top/query_stackless.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint number = gl_GlobalInvocationID.x;
    if (number == 0u) gnoTopBegin(push.count, gnoState(GNO_PRECISION));
    gnoTopSetUp(number, gnoFacing(push.light, engineCaster(number)));
    bool inserted = gnoTopInsert(number);
    GnoViewSample sample_ = GnoViewSample(push.position.xyz, number);
    results.v[number] = vec4(inserted, gnoTopQueryStack(sample_), gnoTopQueryStackless(sample_), gnoTopQueryHybrid(sample_));
}
