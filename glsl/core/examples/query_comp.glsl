// SPDX-License-Identifier: MIT
// main() of every query in a compute shader: one invocation per pixel. GNO_EXAMPLE_QUERY(sample) is the query, a GNO_VISIBILITY_*,
// GNO_EXAMPLE_COUNTS what an instrumented one stores of its counters.
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 2, binding = 2, rgba32ui) uniform readonly uimage2D gnoSamples;
layout(set = 2, binding = 3, r32ui) uniform writeonly uimage2D gnoVisibility;
#if GNO_COUNTERS
layout(set = 2, binding = 4, rgba32ui) uniform writeonly uimage2D gnoCounts;
#ifndef GNO_EXAMPLE_COUNTS
#define GNO_EXAMPLE_COUNTS uvec4(gnoCounters.visitedNodes, gnoCounters.deepestStack, gnoCounters.stackOverflows, gnoCounters.exactCalls)
#endif
#endif

void main() {
    if (any(greaterThanEqual(gl_GlobalInvocationID.xy, gnoPush.size))) return;
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    GnoViewSample s = gnoUnpackViewSample(imageLoad(gnoSamples, pixel));
    uint visibility = s.own == GNO_BACKGROUND ? GNO_VISIBILITY_BACKGROUND : GNO_VISIBILITY_FACING_AWAY;
    if (s.own <= GNO_NO_CASTER) visibility = GNO_EXAMPLE_QUERY(s);
    imageStore(gnoVisibility, pixel, uvec4(visibility));
#if GNO_COUNTERS
    imageStore(gnoCounts, pixel, GNO_EXAMPLE_COUNTS);
#endif
}
