#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
// SPDX-License-Identifier: MIT
// Way C: nodes and casters behind device addresses, as records of 32 and 48 bytes.
#include "gnomon/top/node.h"
layout(buffer_reference, std430, buffer_reference_align = 16) readonly buffer Nodes { GnoTopNode v[]; };
layout(buffer_reference, std430, buffer_reference_align = 16) readonly buffer Corners { vec4 v[]; };
layout(push_constant) uniform Frame { vec4 light; vec4 position; Nodes nodes; Corners corners; uint root; } frame;
GnoTopNode engineLoadNode(uint i) { return frame.nodes.v[i]; }
GnoCaster engineLoadCaster(uint i) {
    return GnoCaster(frame.corners.v[3u * i].xyz, frame.corners.v[3u * i + 1u].xyz, frame.corners.v[3u * i + 2u].xyz);
}
#define GNO_TOP_LOAD_NODE(index_) engineLoadNode(index_)
#define GNO_TOP_LOAD_ANCESTOR(index_) frame.nodes.v[((index_) & ~3u) + 1u].aux
#define GNO_TOP_LOAD_FLAGS(index_) frame.nodes.v[((index_) & ~3u) + 2u].aux
#define GNO_TOP_ROOT frame.root
#define GNO_TOP_STATE gnoState(GNO_PRECISION)  // this engine knows that its tree is built
#define GNO_LIGHT frame.light
#define GNO_LOAD_CASTER(index_) engineLoadCaster(index_)
#include "gnomon/top/query_hybrid.glsl"
#include "gnomon/top/query_stack.glsl"
#include "gnomon/top/query_stackless.glsl"
layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) writeonly buffer Results { uint v[]; } results;

void main() {
    GnoViewSample s = GnoViewSample(frame.position.xyz, GNO_NO_CASTER);
    results.v[gl_GlobalInvocationID.x] = uint(gnoTopQueryHybrid(s)) + uint(gnoTopQueryStack(s)) + uint(gnoTopQueryStackless(s));
}
