#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Must fail with the #error of core/radix_sort.glsl that names GNO_SORT_SORTED_KEYS.
layout(set = 1, binding = 4, std430) buffer Words {
    uint count;
    uint shift;
    uint keys[4096];
    uint values[4096];
    uint sortedKeys[4096];
    uint sortedValues[4096];
    uint counts[64];
}
words;
#define GNO_SORT_LENGTH words.count
#define GNO_SORT_SHIFT words.shift
#define GNO_SORT_KEYS words.keys
#define GNO_SORT_VALUES words.values
#define GNO_SORT_SORTED_VALUES words.sortedValues
#define GNO_SORT_COUNTS words.counts
#include "gnomon/core/radix_sort.glsl"
layout(local_size_x = 64) in;
void main() {}
