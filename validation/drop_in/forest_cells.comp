#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Pure functions; the user passes grid and light.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/forest/cells.h"
layout(set = 2, binding = 4, std140) uniform View { GnoForestGrid grid; } view;
#include "gnomon/forest/cells.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 9, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    GnoCaster caster = GnoCaster(push.position.xyz, push.viewer.xyz, push.light.xyz);
    GnoCellVolume volume = gnoCellVolume(push.light, caster, 1);
    uvec4 rectangle = gnoCellRectangle(push.light, view.grid, at % view.grid.faces, volume);
    uint cell = gnoCellOf(push.light, view.grid, gnoCellPlace(push.light, view.grid, 0u, push.position.xyz));
    bool missed = gnoCellMissed(push.light, view.grid, 0u, rectangle.xy, volume);
    result = vec4(rectangle) + vec4(cell, missed, gnoCellCovered(push.light, view.grid, 0u, rectangle.zw, volume),
                                    gnoCellCount(view.grid.resolution, view.grid.faces));
    results.v[at] = result;
}
