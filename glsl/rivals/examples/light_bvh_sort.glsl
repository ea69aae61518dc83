// SPDX-License-Identifier: MIT
// What the passes of step 4 share. The host binds keys and order to one pair of arrays in even rounds, to the other in odd ones.
#ifndef GNO_LIGHT_BVH_EXAMPLE_SORT_GLSL
#define GNO_LIGHT_BVH_EXAMPLE_SORT_GLSL
#include "../light_bvh.h"
layout(local_size_x = 64) in;
layout(set = 1, binding = 1, std430) readonly buffer GnoLightBvhHeaderBuffer { GnoLightBvhHeader v; } gnoLightBvhHeader;
layout(set = 1, binding = 8, std430) readonly buffer GnoLightBvhKeyBuffer { uint v[]; } gnoLightBvhKeys;
layout(set = 1, binding = 9, std430) readonly buffer GnoLightBvhOrderBuffer { uint v[]; } gnoLightBvhOrder;
layout(set = 2, binding = 0, std430) buffer GnoExampleCounts { uint v[]; } gnoSortCountWords;
layout(set = 2, binding = 1, std430) writeonly buffer GnoExampleSortedKeys { uint v[]; } gnoSortedKeys;
layout(set = 2, binding = 2, std430) writeonly buffer GnoExampleSortedOrder { uint v[]; } gnoSortedOrder;
layout(push_constant) uniform GnoExampleSort { uint shift; } gnoSort;
#define GNO_SORT_LENGTH min(gnoLightBvhHeader.v.references, uint(gnoLightBvhKeys.v.length()))
#define GNO_SORT_SHIFT gnoSort.shift
#define GNO_SORT_KEYS gnoLightBvhKeys.v
#define GNO_SORT_VALUES gnoLightBvhOrder.v
#define GNO_SORT_SORTED_KEYS gnoSortedKeys.v
#define GNO_SORT_SORTED_VALUES gnoSortedOrder.v
#define GNO_SORT_COUNTS gnoSortCountWords.v
#define GNO_PREFIX_WORDS gnoSortCountWords.v
#include "../../core/prefix_sum.glsl"
#include "../../core/radix_sort.glsl"
#endif
