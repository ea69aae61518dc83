// SPDX-License-Identifier: MIT
// core/prefix_sum.glsl and core/radix_sort.glsl on the CPU, made of the same GLSL text that the device runs: work groups of 64 invocations that meet
// at the text's barriers (work_group.hpp). A variant is one compilation of sort_on_cpu.cpp, as with the TOP tree (top_on_cpu.hpp).
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace gno::cpu {

using Words = std::vector<uint32_t>;

struct Sums {
    Words before;  ///< of each invocation
    Words total;   ///< as each invocation was told
};

struct SortVariant {
    std::string name;
    /// gnoGroupPrefix twice in a row, of 64 values each. `order`: of WorkGroup::run.
    std::vector<Sums> (*groupPrefix)(const Words& first, const Words& second, unsigned order);
    /// gnoArrayPrefix of words[0 .. count); `totals`: what each of the 64 invocations was told. What lies behind `count` has to stay.
    Words (*arrayPrefix)(Words words, uint32_t count, Words& totals, unsigned order);
    /// Eight rounds of gnoSortCount, gnoArrayPrefix and gnoSortScatter; values are sorted with their keys. Throws std::runtime_error when the text
    /// leaves its arrays.
    void (*sort)(Words& keys, Words& values, unsigned order);
};

/// All variants that this program is linked with.
inline std::vector<SortVariant>& sortVariants() {
    static std::vector<SortVariant> variants;
    return variants;
}

}  // namespace gno::cpu
