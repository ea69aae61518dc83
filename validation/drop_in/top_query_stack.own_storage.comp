#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way C: the engine's own storage behind the macros; their bodies use names that a module must not capture.
layout(push_constant) uniform Push { vec4 light; vec4 position; uint root; uint state; } push;
// Columns instead of records: an engine's layout, not ours.
layout(set = 0, binding = 3, std430) readonly buffer Corners { vec4 corner[]; } corners;
layout(set = 0, binding = 4, std430) readonly buffer Sides { float nx[4096]; float ny[4096]; float nz[4096]; float offset[4096]; } sides;
layout(set = 0, binding = 8, std430) readonly buffer Children { uvec2 child[4096]; uint wedge[4096]; uint aux[4096]; } children;
#include "gnomon/top/node.h"
// Names that a careless module would capture, of types that fit nowhere else: a local of that name inside the module would not compile.
struct Trap { mat4x3 m; };
Trap node, i, s, index, p, t, q, a, b, c, light, point, side, caster, first, next, stack, used, depth, plane, link, at, root, own, l, n, x, y, z;
float keep(Trap trap) { return trap.m[0][0]; }
#define TRAPS                                                                                                                               \
    (keep(node) + keep(i) + keep(s) + keep(index) + keep(p) + keep(t) + keep(q) + keep(a) + keep(b) + keep(c) + keep(light) + keep(point) + \
     keep(side) + keep(caster) + keep(first) + keep(next) + keep(stack) + keep(used) + keep(depth) + keep(plane) + keep(link) + keep(at) +  \
     keep(root) + keep(own) + keep(l) + keep(n) + keep(x) + keep(y) + keep(z))
uint trapped(uint number, float traps) { return traps == 0.0 ? number : number + 1u; }
GnoTopNode engineNode(uint number) {
    return GnoTopNode(vec4(sides.nx[number], sides.ny[number], sides.nz[number], sides.offset[number]), children.child[number].x,
                      children.child[number].y, children.aux[number], children.wedge[number]);
}
GnoCaster engineCaster(uint number) {
    return GnoCaster(corners.corner[3u * number].xyz, corners.corner[3u * number + 1u].xyz, corners.corner[3u * number + 2u].xyz);
}
vec4 engineLight(float traps) { return push.light + vec4(traps); }
#define GNO_TOP_LOAD_NODE(number) engineNode(trapped(number, TRAPS))
#define GNO_TOP_LOAD_ANCESTOR(number) children.aux[trapped(4u * ((number) / 4u) + 1u, TRAPS)]
#define GNO_TOP_LOAD_FLAGS(number) children.aux[trapped(4u * ((number) / 4u) + 2u, TRAPS)]
#define GNO_TOP_ROOT trapped(push.root, TRAPS)
#define GNO_TOP_STATE trapped(push.state, TRAPS)
#define GNO_LIGHT engineLight(TRAPS)
#define GNO_LOAD_CASTER(number) engineCaster(trapped(number, TRAPS))
#define GNO_PRECISION trapped(2u, TRAPS)
#define GNO_ORIENT3D_ON_EXACT TRAPS
#include "gnomon/top/query_stack.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    result = vec4(gnoTopStackAnswer(GnoViewSample(push.position.xyz, GNO_NO_CASTER)));
    results.v[at] = result;
}
