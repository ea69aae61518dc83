// SPDX-License-Identifier: MIT
// gnomon-sort-mutants [NAME...]: the text of prefix sums and of the radix sort on the CPU, against the standard library's; the invocations of a work
// group run in three orders between any two barriers. What is printed: run.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "validation/mutants/run.hpp"
#include "validation/support/sort_on_cpu.hpp"

namespace gno::mutants {
namespace {

using cpu::Words;

constexpr unsigned kOrders = 3;

Words anyWords(size_t count, uint32_t seed, uint32_t mask = ~0u) {
    std::mt19937 random(seed);
    Words words(count);
    for (uint32_t& word : words) word = uint32_t(random()) & mask;
    return words;
}

std::string groupFailure(const cpu::SortVariant& variant) {
    for (unsigned order = 0; order < kOrders; ++order) {
        const Words values[2] = {anyWords(64, 1), anyWords(64, 2, 0xFFu)};
        const auto got = variant.groupPrefix(values[0], values[1], order);
        for (size_t call = 0; call < 2; ++call) {
            uint32_t sum = 0;
            for (size_t i = 0; i < 64; ++i) {
                if (got[call].before[i] != sum) return fmt::format("group, order {}, call {}: invocation {} has another sum", order, call, i);
                sum += values[call][i];
            }
            for (size_t i = 0; i < 64; ++i)
                if (got[call].total[i] != sum) return fmt::format("group, order {}, call {}: invocation {} has another total", order, call, i);
        }
    }
    return {};
}

std::string arrayFailure(const cpu::SortVariant& variant) {
    for (unsigned order = 0; order < kOrders; ++order)
        for (const size_t count : {0, 1, 2, 63, 64, 65, 127, 128, 129, 1000}) {
            const Words words = anyWords(count + 3, uint32_t(count));
            Words want = words, totals;
            std::exclusive_scan(words.begin(), words.begin() + std::ptrdiff_t(count), want.begin(), 0u);
            const uint32_t total = std::accumulate(words.begin(), words.begin() + std::ptrdiff_t(count), 0u);
            const Words got = variant.arrayPrefix(words, uint32_t(count), totals, order);
            const auto wrong = std::mismatch(got.begin(), got.end(), want.begin()).first - got.begin();
            if (got != want) return fmt::format("array of {} words, order {}: word {} is another", count, order, wrong);
            if (totals != Words(64, total)) return fmt::format("array of {} words, order {}: the total is another", count, order);
        }
    return {};
}

std::string sortFailure(const cpu::SortVariant& variant, const Words& keys, const std::string& what) {
    for (unsigned order = 0; order < kOrders; ++order) {
        Words want(keys.size());
        std::iota(want.begin(), want.end(), 0u);
        Words got = keys, values = want;
        std::stable_sort(want.begin(), want.end(), [&](uint32_t i, uint32_t j) { return keys[i] < keys[j]; });
        variant.sort(got, values, order);
        for (size_t i = 0; i < keys.size(); ++i) {
            if (got[i] != keys[want[i]]) return fmt::format("{}, {} pairs, order {}: the key at {} is another", what, keys.size(), order, i);
            if (values[i] != want[i]) return fmt::format("{}, {} pairs, order {}: the value at {} is another", what, keys.size(), order, i);
        }
    }
    return {};
}

std::string sortFailure(const cpu::SortVariant& variant) {
    for (const size_t length : {0, 1, 2, 15, 16, 17, 63, 64, 65, 1023, 1024, 1025, 2500})
        for (const auto& [what, mask] : {std::pair{"any keys", ~0u}, {"many duplicates", 0x80000003u}, {"all equal", 0u}}) {
            const std::string wrong = sortFailure(variant, anyWords(length, uint32_t(length), mask), what);
            if (!wrong.empty()) return wrong;
        }
    Words each(1500);
    for (size_t i = 0; i < each.size(); ++i) each[i] = 1u << (i * 7 % 32);
    return sortFailure(variant, each, "each bit alone");
}

}  // namespace
}  // namespace gno::mutants

int main(int argc, char** argv) {
    using namespace gno;
    return mutants::run({argv + 1, argv + argc}, cpu::sortVariants(), [](const cpu::SortVariant& variant, bool) -> mutants::Verdict {
        for (const auto check : {mutants::groupFailure, mutants::arrayFailure}) {
            const std::string wrong = check(variant);
            if (!wrong.empty()) return {wrong};
        }
        return {mutants::sortFailure(variant)};
    });
}
