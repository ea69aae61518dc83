#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way C for casters and hull planes; macro bodies use names that a module must not capture.
layout(push_constant) uniform Push { vec4 light; vec4 hull[4]; } push;
#include "gnomon/core/shared_types.h"
layout(set = 1, binding = 6, std430) readonly buffer Corners { vec4 corner[]; } corners;
// Names that a careless module would capture, of types that fit nowhere else: a local of that name inside the module would not compile.
struct Trap { mat4x3 m; };
Trap node, i, s, index, p, t, q, a, b, c, light, point, side, caster, first, next, stack, used, depth, plane, link, at, root, own, l, n, x, y, z;
float keep(Trap trap) { return trap.m[0][0]; }
#define TRAPS                                                                                                                               \
    (keep(node) + keep(i) + keep(s) + keep(index) + keep(p) + keep(t) + keep(q) + keep(a) + keep(b) + keep(c) + keep(light) + keep(point) + \
     keep(side) + keep(caster) + keep(first) + keep(next) + keep(stack) + keep(used) + keep(depth) + keep(plane) + keep(link) + keep(at) +  \
     keep(root) + keep(own) + keep(l) + keep(n) + keep(x) + keep(y) + keep(z))
uint trapped(uint number, float traps) { return traps == 0.0 ? number : number + 1u; }
#define GNO_LOAD_CULL_PLANE(number) push.hull[trapped(number, TRAPS)]
#define GNO_ORIENT3D_ON_EXACT TRAPS
#include "gnomon/core/caster_state.glsl"
layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) writeonly buffer Results { uint v[]; } results;

void main() {
    uint number = gl_GlobalInvocationID.x;
    GnoCaster triangle = GnoCaster(corners.corner[3u * number].xyz, corners.corner[3u * number + 1u].xyz, corners.corner[3u * number + 2u].xyz);
    results.v[number] = gnoCasterState(push.light, triangle, true, GNO_CULL_HULL, 4u);
}
