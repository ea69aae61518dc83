#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Pure functions; the user passes frame, layout and light.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/clusters/cluster.h"
layout(set = 2, binding = 4, std140) uniform View { GnoClusterFrame frame; GnoClusterLayout layout_; } view;
#include "gnomon/clusters/bounds.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    GnoClusterBounds box = gnoClusterBox(push.light, push.viewer.xyz, push.position.xyz);
    GnoClusterBounds cell =
        gnoClusterCell(view.frame, view.layout_, push.light, uvec2(at), uvec2(at + 1u), push.position.x, push.position.y, push.position.w);
    vec2 sides = gnoClusterRange(view.frame, push.light, box, push.viewer) + gnoClusterRange(view.frame, push.light, cell, push.viewer);
    vec2 slope = gnoClusterSlope(view.frame, uvec2(at));
    result = vec4(sides, gnoClusterOutside(view.frame, push.position.xyz, slope, slope), 0.0);
    results.v[at] = result;
}
