#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way C: the engine's own storage behind the macros; their bodies use names that a module must not capture.
layout(push_constant) uniform Push { vec4 light; vec4 position; uint count; uint side; uint built; } push;
#include "gnomon/shadow_map/view.h"
layout(set = 0, binding = 2, std140) uniform Lights { mat4 projection[8]; vec4 shift[8]; } lights;  // an engine's layout, not ours
layout(set = 0, binding = 4, std430) buffer Measured { uint shared_words[64]; } measured;
layout(set = 0, binding = 5, rgba32f) uniform readonly image2D atlas;  // no array, no sampler
// Names that a careless module would capture, of types that fit nowhere else: a local of that name inside the module would not compile.
struct Trap { mat4x3 m; };
Trap view, q, clip, i, s, at, x, y, texel, size, depth, bias, state, faces, facing, steps, value, light, p, index, last, w;
float keep(Trap trap) { return trap.m[0][0]; }
#define TRAPS                                                                                                                                     \
    (keep(view) + keep(q) + keep(clip) + keep(i) + keep(s) + keep(at) + keep(x) + keep(y) + keep(texel) + keep(size) + keep(depth) + keep(bias) + \
     keep(state) + keep(faces) + keep(facing) + keep(steps) + keep(value) + keep(light) + keep(p) + keep(index) + keep(last) + keep(w))
uint trapped(uint number, float traps) { return traps == 0.0 ? number : number + 1u; }
GnoShadowMapView engineView(uint number) {
    mat4 rows = transpose(lights.projection[number]);
    return GnoShadowMapView(rows[0], rows[1], rows[2], rows[3], lights.shift[number]);
}
float engineDepth(uint number, uvec2 where) { return imageLoad(atlas, ivec2(where + uvec2(number * push.side, 0u))).x; }
vec4 engineLight(float traps) { return push.light + vec4(traps); }
#define GNO_LIGHT engineLight(TRAPS)
#define GNO_SHADOW_MAP_STATE trapped(push.built, TRAPS)
#define GNO_SHADOW_MAP_VIEW_COUNT trapped(push.count, TRAPS)
#define GNO_SHADOW_MAP_LOAD_VIEW(number) engineView(trapped(number, TRAPS))
#define GNO_SHADOW_MAP_SIZE trapped(push.side, TRAPS)
#define GNO_SHADOW_MAP_LOAD_DEPTH(number, where) engineDepth(trapped(number, TRAPS), where)
#include "gnomon/shadow_map/query.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint number = gl_GlobalInvocationID.x;
    vec4 result;
    result = vec4(gnoShadowMapQuery(GnoViewSample(push.position.xyz, GNO_NO_CASTER)));
    results.v[number] = result;
}
