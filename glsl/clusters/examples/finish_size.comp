#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Between the passes of the traversal: one invocation writes the arguments of the second one's indirect dispatch.
layout(local_size_x = 1) in;
layout(constant_id = 20) const uint kForm = 1u;
#define GNO_CLUSTER_FORM kForm
layout(constant_id = 23) const uint kGroups = 64u;
#include "../bindings.glsl"

void main() {
    uint jobs = min(gnoClusterHeader.v.jobCount, gnoClusterFrame.v.jobCapacity);
    gnoClusterHeader.v.groups = uvec4(min(kGroups, jobs), 1u, 1u, 0u);
}
