// SPDX-License-Identifier: MIT
// core/permutation.glsl: bijective, random enough for a tree's insertion order, and the same on the device as compiled as C++.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "host_min/vulkan/buffer.hpp"
#include "host_min/vulkan/pass.hpp"
#include "host_min/vulkan/recording.hpp"
#include "validation/support/device_test.hpp"
#include "validation/support/glsl_as_cpp.hpp"
#include "validation/support/spirv_file.hpp"

#include "glsl/core/permutation.glsl"

namespace gno {
namespace {

using Order = std::vector<uint32_t>;

Order permuted(uint32_t count, uint32_t seed) {
    Order order(count);
    for (uint32_t i = 0; i < count; ++i) order[i] = gnoPermute(i, count, seed);
    return order;
}

bool bijective(const Order& order) {
    std::vector<bool> seen(order.size(), false);
    for (const uint32_t x : order) {
        if (x >= order.size() || seen[x]) return false;
        seen[x] = true;
    }
    return true;
}

/// How unlike a random order this one is. Each figure tells one way of being regular.
struct Figures {
    double displacement;   ///< mean |order[i] - i| / n; 1/3 for a random order
    double chiSquare;      ///< place against value, 16 x 16 fields; 225 degrees of freedom
    size_t neighbours;     ///< i with |order[i + 1] - order[i]| = 1; about 2 in a random order
    size_t repeatedSteps;  ///< i whose step to the next is that of i - 1: a lattice has many, a random order about one
    size_t fixedPoints;    ///< about 1
};

Figures figuresOf(const Order& order) {
    const size_t n = order.size();
    Figures f{0, 0, 0, 0, 0};
    std::array<double, 256> fields{};
    for (size_t i = 0; i < n; ++i) {
        f.displacement += std::fabs(double(order[i]) - double(i)) / double(n) / double(n);
        f.fixedPoints += order[i] == i ? 1u : 0u;
        fields[i * 16 / n * 16 + size_t{order[i]} * 16 / n] += 1;
        if (i + 1 == n) continue;
        const int64_t step = int64_t{order[i + 1]} - int64_t{order[i]};
        f.neighbours += std::abs(step) == 1 ? 1u : 0u;
        if (i > 0) f.repeatedSteps += step == int64_t{order[i]} - int64_t{order[i - 1]} ? 1u : 0u;
    }
    const double expected = double(n) / 256;
    for (const double field : fields) f.chiSquare += (field - expected) * (field - expected) / expected;
    return f;
}

bool randomEnough(const Order& order) {
    const Figures f = figuresOf(order);
    return std::fabs(f.displacement - 1.0 / 3) < 0.03 && f.chiSquare < 340 && f.neighbours < 20 && f.repeatedSteps < 20 && f.fixedPoints < 12;
}

constexpr uint32_t kLarge[] = {1u << 20, (1u << 20) + 1, 1150000};
constexpr uint32_t kSeeds[] = {0, 1, 2, 12345, 0xFFFFFFFFu};

TEST(Permutation, IsBijectiveForAllSmallCounts) {
    for (uint32_t count = 1; count <= 300; ++count)
        for (const uint32_t seed : kSeeds) ASSERT_TRUE(bijective(permuted(count, seed))) << count << ", seed " << seed;
}

TEST(Permutation, IsBijectiveForLargeCounts) {
    for (const uint32_t count : kLarge)
        for (const uint32_t seed : {0u, 7u}) ASSERT_TRUE(bijective(permuted(count, seed))) << count << ", seed " << seed;
}

TEST(Permutation, StaysBelowTheLargestCount) {
    const uint32_t count = 1u << 31;
    Order some;
    for (uint32_t i = 0; i < 100000; ++i) some.push_back(gnoPermute(i * 21474u, count, 3));
    for (const uint32_t x : some) ASSERT_LT(x, count);
    std::sort(some.begin(), some.end());
    EXPECT_EQ(std::adjacent_find(some.begin(), some.end()), some.end());
}

TEST(Permutation, SeedsGiveDifferentOrders) {
    for (const uint32_t count : {64u, 4096u, 100003u}) {
        const Order first = permuted(count, 0);
        for (uint32_t seed = 1; seed < 20; ++seed) {
            const Order other = permuted(count, seed);
            size_t same = 0;
            for (size_t i = 0; i < first.size(); ++i) same += first[i] == other[i] ? 1u : 0u;
            EXPECT_LT(same, 12u) << count << ", seed " << seed;  // about 1 in random orders
        }
    }
}

TEST(Permutation, IsRandomEnough) {
    for (const uint32_t count : {4096u, 5000u, 65536u, 100003u, 1u << 20})
        for (uint32_t seed = 0; seed < 8; ++seed) {
            const Order order = permuted(count, seed);
            const Figures f = figuresOf(order);
            EXPECT_TRUE(randomEnough(order)) << count << ", seed " << seed << ": displacement " << f.displacement << ", chi square " << f.chiSquare
                                             << ", neighbours " << f.neighbours << ", repeated steps " << f.repeatedSteps << ", fixed points "
                                             << f.fixedPoints;
        }
}

/// Orders that are bijective but bad to insert in must not pass for random.
TEST(Permutation, FiguresSeeRegularOrders) {
    constexpr uint32_t n = 4096;
    Order order(n);
    std::iota(order.begin(), order.end(), 0u);
    EXPECT_FALSE(randomEnough(order)) << "mesh order";
    std::reverse(order.begin(), order.end());
    EXPECT_FALSE(randomEnough(order)) << "backwards";
    for (uint32_t i = 0; i < n; ++i) order[i] = i * 2531u % n;
    EXPECT_TRUE(bijective(order));
    EXPECT_FALSE(randomEnough(order)) << "a lattice";
    order = permuted(n, 1);
    for (uint32_t i = 0; i + 64 < n; i += 128) std::sort(order.begin() + i, order.begin() + i + 64);
    std::sort(order.begin(), order.begin() + n / 8);
    EXPECT_FALSE(randomEnough(order)) << "sorted runs";
    order[0] = order[1];
    EXPECT_FALSE(bijective(order));
}

TEST(Permutation, DeviceMakesTheSameOrder) {
    const host::Device& device = test::passes().device();
    const host::ComputePass pass(device, test::readSpirv(GNOMON_PERMUTATION_SPIRV));
    for (const uint32_t count : {1u, 2u, 3u, 100u, 257u, 65536u, 100003u, 1u << 20, 1150000u})
        for (const uint32_t seed : {0u, 12345u, 0xFFFFFFFFu}) {
            host::Buffer out(device, count * 4ull);
            out.fill(0xDEADBEEFu);
            const std::array<uint32_t, 2> push{count, seed};
            const std::array resources{host::Binding{"order", &out}};
            host::Recording recording(device);
            recording.beginPass("permute");
            pass.dispatch(recording, resources, std::as_bytes(std::span(push)), (count + 63) / 64);
            recording.endPass();
            recording.submit();
            Order got = out.downloadAs<uint32_t>();
            got.resize(count);
            ASSERT_EQ(got, permuted(count, seed)) << count << ", seed " << seed;
        }
}

}  // namespace
}  // namespace gno
