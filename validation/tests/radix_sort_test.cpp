// SPDX-License-Identifier: MIT
// core/radix_sort.glsl and core/prefix_sum.glsl on the device against std::stable_sort: any length, any keys, equal keys in their order.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "glsl/core/radix_sort.h"
#include "glsl/rivals/light_bvh.h"
#include "host_min/vulkan/recording.hpp"
#include "validation/support/device_test.hpp"

namespace gno {
namespace {

constexpr uint32_t kSeed = 8, kPoison = 0xDEADBEEFu;

struct Pairs {
    std::vector<uint32_t> keys, values;
};

/// Eight rounds; values are the places where the keys stood.
Pairs sortedByDevice(const std::vector<uint32_t>& keys) {
    const host::Device& device = test::passes().device();
    const auto length = uint32_t(keys.size());
    host::Buffer header(device, sizeof(GnoLightBvhHeader)), counts(device, 4 * uint64_t(gnoSortCounts(length)));
    GnoLightBvhHeader words{};
    words.references = length;
    header.upload(std::as_bytes(std::span(&words, 1)));
    counts.fill(kPoison);
    host::Buffer list[2][2] = {{{device, 4 * uint64_t(length)}, {device, 4 * uint64_t(length)}},
                               {{device, 4 * uint64_t(length)}, {device, 4 * uint64_t(length)}}};
    for (auto& side : list)
        for (host::Buffer& buffer : side) buffer.fill(kPoison);
    std::vector<uint32_t> order(length);
    std::iota(order.begin(), order.end(), 0u);
    if (length > 0) {
        list[0][0].upload(std::span(keys));
        list[0][1].upload(std::span(std::as_const(order)));
    }
    host::Recording recording(device);
    for (uint32_t round = 0; round < GNO_SORT_ROUNDS; ++round) {
        const auto& from = list[round % 2];
        const auto& to = list[1 - round % 2];
        const std::vector<host::Binding> all{{"gnoLightBvhHeader", &header}, {"gnoSortCountWords", &counts}, {"gnoLightBvhKeys", &from[0]},
                                             {"gnoLightBvhOrder", &from[1]}, {"gnoSortedKeys", &to[0]},      {"gnoSortedOrder", &to[1]}};
        host::ExamplePush frame{};
        frame.number = 4 * round;
        const auto push = std::as_bytes(std::span(&frame, 1));
        for (const char* step : {"count", "prefix", "scatter"}) {
            recording.barrier();
            const bool one = std::string(step) == "prefix";
            test::passes()
                .compute(fmt::format("rivals/examples/light_bvh_sort_{}.comp", step))
                .dispatch(recording, all, push, one ? 1 : gnoSortTiles(length));
        }
    }
    recording.submit();
    Pairs result{list[0][0].downloadAs<uint32_t>(), list[0][1].downloadAs<uint32_t>()};
    for (auto* words32 : {&result.keys, &result.values}) {
        for (size_t i = length; i < words32->size(); ++i) EXPECT_EQ((*words32)[i], kPoison) << "written past the end";
        words32->resize(length);
    }
    return result;
}

void expectSorted(const std::vector<uint32_t>& keys, const std::string& what) {
    std::vector<uint32_t> order(keys.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t i, uint32_t j) { return keys[i] < keys[j]; });
    const Pairs got = sortedByDevice(keys);
    EXPECT_EQ(got.values, order) << what << ", " << keys.size() << " pairs, seed " << kSeed;
    for (size_t i = 0; i < keys.size(); ++i) ASSERT_EQ(got.keys[i], keys[order[i]]) << what << ", place " << i;
}

TEST(RadixSort, AnyLengthAndAnyKeys) {
    std::mt19937 random(kSeed);
    for (const size_t length : {0, 1, 2, 15, 16, 17, 63, 64, 65, 1023, 1024, 1025, 4097, 70000}) {
        std::vector<uint32_t> keys(length);
        std::generate(keys.begin(), keys.end(), random);
        expectSorted(keys, "any keys");
        for (uint32_t& key : keys) key &= 0x80000003u;
        expectSorted(keys, "many duplicates");
    }
}

TEST(RadixSort, KeysInSomeOrder) {
    std::vector<uint32_t> keys(2500, 0x12345678u);
    expectSorted(keys, "all equal");
    std::iota(keys.begin(), keys.end(), 0xFFFFFFFFu - 2499u);
    expectSorted(keys, "sorted");
    std::reverse(keys.begin(), keys.end());
    expectSorted(keys, "reversed");
    for (size_t i = 0; i < keys.size(); ++i) keys[i] = 1u << (i % 32);
    expectSorted(keys, "each digit alone");
}

}  // namespace
}  // namespace gno
