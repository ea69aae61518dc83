#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Pure functions; the user passes frame and layout.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/clusters/cluster.h"
layout(set = 2, binding = 4, std140) uniform View { GnoClusterFrame frame; GnoClusterLayout layout_; } view;
#include "gnomon/clusters/key.glsl"
layout(location = 0) out vec4 result;

void main() {
    uint at = uint(gl_FragCoord.x);
    uint ordered = gnoClusterOrdered(gnoClusterDepth(view.frame, push.position.xyz));
    uint key = gnoClusterDeposit(at, view.layout_.maskX);
    result = vec4(gnoClusterFromOrdered(ordered), float(gnoClusterExtract(key, view.layout_.maskX)),
                  gnoClusterSliceStart(view.frame, view.layout_, push.position.x, push.position.y, at), 0.0);
}
