// SPDX-License-Identifier: MIT
// What the passes of the sort share: GNO_SORT_RUNS says which of the sort's functions this one calls, 0: neither, it makes prefix sums;
// gnoPush.number is the shift. The host binds keys and order to one pair of arrays in even rounds, to the other in odd ones.
#ifndef GNO_LIGHT_BVH_EXAMPLE_SORT_GLSL
#define GNO_LIGHT_BVH_EXAMPLE_SORT_GLSL
#include "../../core/examples/frame.glsl"
#include "../../core/radix_sort.h"
#include "../light_bvh.h"
layout(local_size_x = 64) in;
layout(set = 1, binding = 1, std430) readonly buffer GnoLightBvhHeaderBuffer { GnoLightBvhHeader v; } gnoLightBvhHeader;
layout(set = 1, binding = 8, std430) readonly buffer GnoLightBvhKeyBuffer { uint v[]; } gnoLightBvhKeys;
#define GNO_SORT_LENGTH min(gnoLightBvhHeader.v.references, uint(gnoLightBvhKeys.v.length()))
#define GNO_SORT_SHIFT gnoPush.number
#define GNO_SORT_KEYS gnoLightBvhKeys.v
#define GNO_SORT_COUNTS gnoSortCountWords.v
#if GNO_SORT_RUNS == GNO_SORT_PASS_SCATTER
layout(set = 1, binding = 9, std430) readonly buffer GnoLightBvhOrderBuffer { uint v[]; } gnoLightBvhOrder;
layout(set = 2, binding = 15, std430) readonly buffer GnoExampleCounts { uint v[]; } gnoSortCountWords;
layout(set = 2, binding = 16, std430) writeonly buffer GnoExampleSortedKeys { uint v[]; } gnoSortedKeys;
layout(set = 2, binding = 17, std430) writeonly buffer GnoExampleSortedOrder { uint v[]; } gnoSortedOrder;
#define GNO_SORT_VALUES gnoLightBvhOrder.v
#define GNO_SORT_SORTED_KEYS gnoSortedKeys.v
#define GNO_SORT_SORTED_VALUES gnoSortedOrder.v
#else
layout(set = 2, binding = 15, std430) buffer GnoExampleCounts { uint v[]; } gnoSortCountWords;
#endif
#if GNO_SORT_RUNS
#include "../../core/radix_sort.glsl"
#else
#define GNO_PREFIX_WORDS gnoSortCountWords.v
#include "../../core/prefix_sum.glsl"
#endif
#endif
