// SPDX-License-Identifier: MIT
// One variant: GNO_SORT_VARIANT is its name. A variant of other text finds it first on its include path (-iquote).
// Everything is in an unnamed namespace, so that one program can hold many.
#include "validation/support/sort_on_cpu.hpp"

#include "validation/support/checked_array.hpp"
#include "validation/support/glsl_as_cpp.hpp"
#include "validation/support/work_group.hpp"

#ifndef GNO_SORT_VARIANT
#error "define GNO_SORT_VARIANT, a name"
#endif

namespace gno {
namespace {

using cpu::barrier;
using cpu::Sums;
using cpu::Words;
using cpu::WorkGroup;
using Array = cpu::CheckedArray<uint>;

constexpr uint kPoison = 0xDEADBEEFu;

struct State {
    Array words;  // of the prefix sums, and the sort's counts
    Array keys[2], values[2];
    uint length = 0, shift = 0, from = 0;  // 0: from the first pair of arrays to the second
} state;

#define GNO_PREFIX_WORDS state.words
#define GNO_SORT_LENGTH state.length
#define GNO_SORT_SHIFT state.shift
#define GNO_SORT_KEYS state.keys[state.from]
#define GNO_SORT_VALUES state.values[state.from]
#define GNO_SORT_SORTED_KEYS state.keys[1u - state.from]
#define GNO_SORT_SORTED_VALUES state.values[1u - state.from]
#define GNO_SORT_COUNTS state.words

#undef GNO_NAMESPACE_BEGIN
#undef GNO_NAMESPACE_END
#define GNO_NAMESPACE_BEGIN
#define GNO_NAMESPACE_END
#define shared static
#include "glsl/core/prefix_sum.glsl"
#include "glsl/core/radix_sort.glsl"
#undef shared

/// One work group; its shared memory holds what another one left there.
template <class Work>
void group(uint invocations, uint order, const Work& work) {
    for (uint& word : gnoPrefixShared_) word = kPoison;
    for (uint& word : gnoSortShared_) word = kPoison;
    for (uint& word : gnoSortSums_) word = kPoison;
    WorkGroup::run(invocations, work, order);
}

std::vector<Sums> groupPrefix(const Words& first, const Words& second, unsigned order) {
    std::vector<Sums> sums(2, {Words(first.size()), Words(first.size())});
    group(GNO_PREFIX_GROUP, order, [&](uint i) {
        sums[0].before[i] = gnoGroupPrefix(first[i], i, sums[0].total[i]);
        sums[1].before[i] = gnoGroupPrefix(second[i], i, sums[1].total[i]);
    });
    return sums;
}

Words arrayPrefix(Words words, uint32_t count, Words& totals, unsigned order) {
    state.words.assign(words.begin(), words.end());
    totals.assign(GNO_PREFIX_GROUP, kPoison);
    group(GNO_PREFIX_GROUP, order, [&](uint i) { totals[i] = gnoArrayPrefix(count, i); });
    return {state.words.begin(), state.words.end()};
}

void sort(Words& keys, Words& values, unsigned order) {
    state.length = uint(keys.size());
    state.keys[0].assign(keys.begin(), keys.end());
    state.values[0].assign(values.begin(), values.end());
    for (auto* array : {&state.keys[1], &state.values[1]}) array->assign(keys.size(), kPoison);
    state.words.assign(gnoSortCounts(state.length), kPoison);
    const uint tiles = gnoSortTiles(state.length);
    for (uint round = 0; round < GNO_SORT_ROUNDS; ++round) {
        state.shift = 4 * round;
        state.from = round % 2;
        for (uint tile = 0; tile < tiles; ++tile) group(GNO_SORT_GROUP, order, [&](uint i) { gnoSortCount(tile, i); });
        group(GNO_PREFIX_GROUP, order, [&](uint i) { gnoArrayPrefix(gnoSortCounts(state.length), i); });
        for (uint tile = 0; tile < tiles; ++tile)
            group(GNO_SORT_GROUP, order, [&](uint i) { gnoSortScatter(order % 2 ? tiles - 1 - tile : tile, i); });
    }
    keys.assign(state.keys[0].begin(), state.keys[0].end());
    values.assign(state.values[0].begin(), state.values[0].end());
}

[[maybe_unused]] const bool kRegistered = (cpu::sortVariants().push_back({GNO_SORT_VARIANT, groupPrefix, arrayPrefix, sort}), true);

}  // namespace
}  // namespace gno
