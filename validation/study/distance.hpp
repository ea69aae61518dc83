// SPDX-License-Identifier: MIT
// How far wrong samples lie from the nearest boundary of the exact answers, in pixels.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace gno::study {

inline constexpr uint64_t kNoAnswer = ~0ull;  ///< a pixel without view sample
inline constexpr int64_t kNoBoundary = -1;    ///< no pixel is marked

/// 1 for each view sample with a view sample among its eight neighbours whose answer is another one. One answer per pixel, or kNoAnswer.
std::vector<uint8_t> boundaryOf(uint32_t width, uint32_t height, std::span<const uint64_t> answers);

/// For each pixel the squared Euclidean distance to the nearest marked one, exact; kNoBoundary everywhere when none is marked.
/// Felzenszwalb and Huttenlocher, Distance Transforms of Sampled Functions, 2012, in whole numbers.
std::vector<int64_t> squaredDistances(uint32_t width, uint32_t height, std::span<const uint8_t> marked);

struct DistanceHistogram {
    std::vector<uint64_t> lowerEnds;  ///< 0, 1, 2, 4, 8, ...: the last one still holds a sample
    std::vector<uint64_t> samples;    ///< with lowerEnds[i] <= distance < lowerEnds[i + 1]
    double max = 0, mean = 0;
};

/// Of the given pixels. Without any boundary they count with `farthest`, the picture's diagonal.
DistanceHistogram distanceHistogram(std::span<const uint32_t> pixels, std::span<const int64_t> squared, double farthest);

}  // namespace gno::study
