#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_ray_query : require
// SPDX-License-Identifier: MIT
// Way C: the engine's own structure of many instances, whose casters are numbered by a table; macro bodies use names that a module must not capture.
layout(push_constant) uniform Push { vec4 light; vec4 position; } push;
layout(set = 0, binding = 3) uniform accelerationStructureEXT worlds[2];
layout(set = 0, binding = 4, std430) readonly buffer FirstCasters { uint first[]; } firstCasters;
// Names that a careless module would capture, of types that fit nowhere else: a local of that name inside the module would not compile.
struct Trap { mat4x3 m; };
Trap query, s, light, towards, direction, end, origin, own, caster, primitive, hit, t, i, p;
float keep(Trap trap) { return trap.m[0][0]; }
#define TRAPS (keep(query) + keep(s) + keep(light) + keep(towards) + keep(direction) + keep(end) + keep(origin) + keep(own) + keep(caster) + \
               keep(primitive) + keep(hit) + keep(t) + keep(i) + keep(p))
uint trapped(uint number, float traps) { return traps == 0.0 ? number : number + 1u; }
vec4 engineLight(float traps) { return push.light + vec4(traps); }
#define GNO_LIGHT engineLight(TRAPS)
#define GNO_RAY_QUERY_STRUCTURE worlds[1]
#define GNO_RAY_QUERY_CASTER(number)                                                           \
    trapped(firstCasters.first[rayQueryGetIntersectionInstanceCustomIndexEXT(number, false)] + \
                uint(rayQueryGetIntersectionPrimitiveIndexEXT(number, false)),                 \
            TRAPS)
#include "gnomon/rivals/ray_query.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    result = vec4(gnoRayQueryInShadow(GnoViewSample(push.position.xyz, at)));
    results.v[at] = result;
}
