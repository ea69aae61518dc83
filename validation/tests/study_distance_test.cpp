// SPDX-License-Identifier: MIT
// The distance transform against brute force, the boundary and the histogram on cases counted by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "validation/study/distance.hpp"

namespace gno::study {
namespace {

std::vector<int64_t> bruteForce(uint32_t width, const std::vector<uint8_t>& marked) {
    std::vector<int64_t> result(marked.size(), kNoBoundary);
    for (size_t i = 0; i < marked.size(); ++i)
        for (size_t j = 0; j < marked.size(); ++j) {
            if (!marked[j]) continue;
            const int64_t dx = int64_t(i % width) - int64_t(j % width), dy = int64_t(i / width) - int64_t(j / width);
            const int64_t d = dx * dx + dy * dy;
            if (result[i] == kNoBoundary || d < result[i]) result[i] = d;
        }
    return result;
}

TEST(Distance, IsTheBruteForceOne) {
    constexpr uint32_t kSeed = 20140314;
    std::printf("seed %u\n", kSeed);
    std::mt19937 random(kSeed);
    for (const auto& [width, height] : {std::pair{1u, 1u}, {1u, 17u}, {23u, 1u}, {16u, 16u}, {37u, 29u}, {64u, 5u}}) {
        for (const double share : {0.002, 0.02, 0.3, 1.0}) {
            std::bernoulli_distribution mark(share);
            std::vector<uint8_t> marked(size_t(width) * height);
            for (uint8_t& m : marked) m = mark(random);
            EXPECT_EQ(squaredDistances(width, height, marked), bruteForce(width, marked)) << width << "x" << height << " share " << share;
        }
    }
}

TEST(Distance, OneMarkInAnyCorner) {
    constexpr uint32_t kWidth = 40, kHeight = 30;
    for (const size_t at : {size_t(0), size_t(kWidth - 1), size_t(kWidth) * (kHeight - 1), size_t(kWidth) * kHeight - 1}) {
        std::vector<uint8_t> marked(size_t(kWidth) * kHeight, 0);
        marked[at] = 1;
        EXPECT_EQ(squaredDistances(kWidth, kHeight, marked), bruteForce(kWidth, marked));
    }
}

TEST(Distance, NothingMarked) {
    for (const int64_t d : squaredDistances(5, 4, std::vector<uint8_t>(20, 0))) EXPECT_EQ(d, kNoBoundary);
}

TEST(Boundary, IsOnBothSidesAndNotAtPixelsWithoutAnswer) {
    const uint64_t n = kNoAnswer;
    const std::vector<uint64_t> answers{0, 0, 0, 1, 1,  //
                                        0, 0, 0, 1, 1,  //
                                        n, n, n, n, n,  //
                                        0, 0, 1, 0, 0};
    const std::vector<uint8_t> want{0, 0, 1, 1, 0,  //
                                    0, 0, 1, 1, 0,  //
                                    0, 0, 0, 0, 0,  //
                                    0, 1, 1, 1, 0};
    EXPECT_EQ(boundaryOf(5, 4, answers), want);
    const std::vector<uint64_t> diagonal{0, n, n, 1};
    EXPECT_EQ(boundaryOf(2, 2, diagonal), (std::vector<uint8_t>{1, 0, 0, 1}));
}

TEST(Histogram, BinsBeginAtTheirLowerEnd) {
    const std::vector<int64_t> squared{0, 1, 2, 4, 15, 16, 9};
    const std::vector<uint32_t> pixels{0, 1, 2, 3, 4, 5};
    const DistanceHistogram histogram = distanceHistogram(pixels, squared, 100);
    EXPECT_EQ(histogram.lowerEnds, (std::vector<uint64_t>{0, 1, 2, 4}));
    EXPECT_EQ(histogram.samples, (std::vector<uint64_t>{1, 2, 2, 1}));
    EXPECT_DOUBLE_EQ(histogram.max, 4);
    EXPECT_NEAR(histogram.mean, (0 + 1 + std::sqrt(2.0) + 2 + std::sqrt(15.0) + 4) / 6, 1e-12);
}

TEST(Histogram, WithoutABoundaryTheDiagonalCounts) {
    const std::vector<int64_t> squared(4, kNoBoundary);
    const DistanceHistogram histogram = distanceHistogram(std::vector<uint32_t>{1, 2}, squared, 5);
    EXPECT_EQ(histogram.samples, (std::vector<uint64_t>{0, 0, 0, 2}));
    EXPECT_DOUBLE_EQ(histogram.max, 5);
}

TEST(Histogram, NobodyWrong) {
    const DistanceHistogram histogram = distanceHistogram({}, {}, 5);
    EXPECT_TRUE(histogram.samples.empty());
    EXPECT_DOUBLE_EQ(histogram.max, 0);
}

}  // namespace
}  // namespace gno::study
