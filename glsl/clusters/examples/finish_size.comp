#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Between the passes of the traversal: one invocation writes the arguments of the second one's indirect dispatch.
#include "../../core/constant_ids.h"
layout(local_size_x = 1) in;
layout(constant_id = GNO_ID_FORM) const uint kForm = 1u;
#define GNO_CLUSTER_FORM kForm
layout(constant_id = GNO_ID_GROUPS) const uint kGroups = 64u;
#define GNO_CLUSTER_BUILDS GNO_CLUSTER_PASS_SIZES
#include "../bindings.glsl"

void main() {
    uint jobs = min(gnoClusterHeader.v.jobCount, gnoClusterFrame.v.jobCapacity);
    gnoClusterHeader.v.groups = uvec4(min(kGroups, jobs), 1u, 1u, 0u);
}
