// SPDX-License-Identifier: MIT
// Node loads that keep a log, for the trace_*.comp: the queries are the modules' own, their macros are fulfilled by functions that count and note
// what is loaded.
// Include after ../bindings.glsl and before a query.
#ifndef GNO_TOP_TRACE_GLSL
#define GNO_TOP_TRACE_GLSL

// How a query came to a node.
const uint GNO_TOP_TRACE_ROOT = 0u;          // its first node
const uint GNO_TOP_TRACE_NEGATIVE = 1u;      // the next plane of the same volume
const uint GNO_TOP_TRACE_POSITIVE = 2u;      // by the link of the node before
const uint GNO_TOP_TRACE_INTERSECTION = 3u;  // the same
const uint GNO_TOP_TRACE_POP = 4u;           // from the stack: an intersection child of an earlier node
const uint GNO_TOP_TRACE_ANCESTOR = 5u;      // back by an ancestor link
const uint GNO_TOP_TRACE_RESTART = 6u;       // the root again, without a stack, because the stack was full

layout(set = 2, binding = 8, std430) buffer GnoTopVisitBuffer { uint v[]; } gnoTopVisits;  // per node; atomics
layout(set = 2, binding = 9, std430) buffer GnoTopTraceBuffer {
    uvec2 pixel;    // the one that is logged
    uint count;     // nodes it visited; written by its invocation alone
    uint capacity;  // entries of v
    uvec2 v[];      // node, GNO_TOP_TRACE_*
} gnoTopTrace;

uint gnoTraceCount = 0u;
uint gnoTraceIndex = GNO_TOP_NONE;  // the node before
GnoTopNode gnoTraceNode;
bool gnoTraceAncestor = false;      // an ancestor link was followed from there

uint gnoTraceStep_(uint index_) {
    if (gnoTraceCount == 0u) return GNO_TOP_TRACE_ROOT;
    if (gnoTraceAncestor) return GNO_TOP_TRACE_ANCESTOR;
    if (index_ == gnoTraceNode.intersectionChild) return GNO_TOP_TRACE_INTERSECTION;
    if (index_ == gnoTraceNode.positiveChild) return GNO_TOP_TRACE_POSITIVE;
    if ((index_ & 3u) != 0u && index_ == gnoTraceIndex + 1u) return GNO_TOP_TRACE_NEGATIVE;
    return index_ == GNO_TOP_ROOT ? GNO_TOP_TRACE_RESTART : GNO_TOP_TRACE_POP;
}

GnoTopNode gnoTraceLoadNode(uint index_) {
    GnoTopNode node_ = gnoTopLoadNode(index_);
    atomicAdd(gnoTopVisits.v[index_], 1u);
    if (gl_GlobalInvocationID.xy == gnoTopTrace.pixel) {
        if (gnoTraceCount < gnoTopTrace.capacity) gnoTopTrace.v[gnoTraceCount] = uvec2(index_, gnoTraceStep_(index_));
        gnoTopTrace.count = gnoTraceCount + 1u;
    }
    ++gnoTraceCount;
    gnoTraceIndex = index_;
    gnoTraceNode = node_;
    gnoTraceAncestor = false;
    return node_;
}

uint gnoTraceLoadAncestor(uint index_) {
    gnoTraceAncestor = true;
    return gnoTopLinks.v[(index_ & ~3u) + 1u].aux;
}

#undef GNO_TOP_LOAD_NODE
#undef GNO_TOP_LOAD_ANCESTOR
#define GNO_TOP_LOAD_NODE(index_) gnoTraceLoadNode(index_)
#define GNO_TOP_LOAD_ANCESTOR(index_) gnoTraceLoadAncestor(index_)
#endif
