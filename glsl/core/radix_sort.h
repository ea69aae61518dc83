// SPDX-License-Identifier: MIT
// gnomon core/radix_sort.h : sizes of a radix sort's tiles and counts; read by glslang and by C++20 (namespace gno).
//
//   uint gnoSortTiles(uint length)         tiles of that many pairs
//   uint gnoSortCounts(uint length)        words of the counts
//
// Space      none: no positions
// Stages     any
// Requires   #version 450, no extension
#ifndef GNO_CORE_RADIX_SORT_H
#define GNO_CORE_RADIX_SORT_H
#include "shared_types.h"
#define GNO_SORT_PASS_COUNT 2    // writes counts
#define GNO_SORT_PASS_SCATTER 4  // writes sorted keys and values
GNO_NAMESPACE_BEGIN

GNO_CONST uint GNO_SORT_GROUP = 64u;    // invocations of a work group
GNO_CONST uint GNO_SORT_SHARE = 16u;    // pairs of an invocation
GNO_CONST uint GNO_SORT_TILE = 1024u;   // pairs of a work group
GNO_CONST uint GNO_SORT_DIGITS = 16u;   // values of a digit
GNO_CONST uint GNO_SORT_ROUNDS = 8u;    // of 4 bits, for all 32

GNO_INLINE uint gnoSortTiles(uint length_) { return (length_ + GNO_SORT_TILE - 1u) / GNO_SORT_TILE; }
GNO_INLINE uint gnoSortCounts(uint length_) { return GNO_SORT_DIGITS * gnoSortTiles(length_); }

GNO_NAMESPACE_END
#endif
