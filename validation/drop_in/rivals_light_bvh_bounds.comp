#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Pure functions; the user passes grid and light.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/forest/cells.h"
layout(set = 2, binding = 4, std140) uniform View { GnoForestGrid grid; } view;
#include "gnomon/rivals/light_bvh_bounds.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 9, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    GnoCaster caster = GnoCaster(push.position.xyz, push.viewer.xyz, push.light.xyz);
    GnoLightBvhCaster seen = gnoLightBvhCaster(push.light, caster, 1);
    uint low, high;
    bool met = gnoLightBvhBounds(push.light, view.grid, at % view.grid.faces, seen, low, high);
    GnoLightBvhBox box = GnoLightBvhBox(low, high, 0.0, 0u);
    box = gnoLightBvhUnion(box, GnoLightBvhBox(high, low, 1.0, 0u));
    result = vec4(gnoLightBvhFaces(push.light, view.grid, seen), gnoLightBvhKey(0u, low, high), gnoLightBvhArea(box.low, box.high),
                  met && gnoLightBvhHolds(low, high, push.seed));
    results.v[at] = result;
}
