#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Pure functions; the user passes frame, layout and light.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/clusters/cluster.h"
layout(set = 2, binding = 4, std140) uniform View { GnoClusterFrame frame; GnoClusterLayout layout_; } view;
#include "gnomon/clusters/bounds.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    GnoClusterBounds box = gnoClusterBox(push.light, push.viewer.xyz, push.position.xyz);
    GnoClusterBounds cell =
        gnoClusterCell(view.frame, view.layout_, push.light, uvec2(at), uvec2(at + 1u), push.position.x, push.position.y, push.position.w);
    vec2 sides = gnoClusterRange(view.frame, push.light, box, push.viewer) + gnoClusterRange(view.frame, push.light, cell, push.viewer);
    vec2 slope = gnoClusterSlope(view.frame, uvec2(at));
    result = vec4(sides, gnoClusterOutside(view.frame, push.position.xyz, slope, slope), 0.0);
}
