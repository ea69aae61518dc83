// SPDX-License-Identifier: MIT
#include "validation/study/distance.hpp"

#include <algorithm>
#include <cmath>

namespace gno::study {
namespace {

constexpr int64_t kFar = int64_t(1) << 40;  // beyond any square in a picture

int64_t floorDivided(int64_t a, int64_t b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }  // b > 0

/// f[x] becomes the least (x - q)^2 + f[q] over all q: the lower envelope of parabolas.
void lowerEnvelope(std::vector<int64_t>& f, std::vector<size_t>& vertex, std::vector<int64_t>& from, std::vector<int64_t>& result) {
    size_t last = 0;
    vertex[0] = 0;
    from[0] = -kFar;
    for (size_t q = 1; q < f.size(); ++q) {
        const auto begin = [&] {  // the first whole x at which q's parabola lies below the last one of the envelope; above -kFar
            const auto a = int64_t(vertex[last]), b = int64_t(q);
            return floorDivided(f[q] + b * b - f[vertex[last]] - a * a, 2 * (b - a)) + 1;
        };
        while (begin() <= from[last]) --last;
        const int64_t start = begin();
        vertex[++last] = q;
        from[last] = start;
    }
    size_t current = 0;
    for (size_t x = 0; x < f.size(); ++x) {
        while (current < last && from[current + 1] <= int64_t(x)) ++current;
        const int64_t d = int64_t(x) - int64_t(vertex[current]);
        result[x] = std::min(d * d + f[vertex[current]], kFar);
    }
    std::copy(result.begin(), result.begin() + ptrdiff_t(f.size()), f.begin());
}

}  // namespace

std::vector<uint8_t> boundaryOf(uint32_t width, uint32_t height, std::span<const uint64_t> answers) {
    std::vector<uint8_t> marked(answers.size(), 0);
    const auto at = [&](int64_t x, int64_t y) {
        return x < 0 || y < 0 || x >= width || y >= height ? kNoAnswer : answers[size_t(y) * width + size_t(x)];
    };
    for (int64_t y = 0; y < height; ++y) {
        for (int64_t x = 0; x < width; ++x) {
            const uint64_t own = at(x, y);
            if (own == kNoAnswer) continue;
            for (int64_t dy = -1; dy <= 1; ++dy)
                for (int64_t dx = -1; dx <= 1; ++dx)
                    if (const uint64_t other = at(x + dx, y + dy); other != kNoAnswer && other != own) marked[size_t(y) * width + size_t(x)] = 1;
        }
    }
    return marked;
}

std::vector<int64_t> squaredDistances(uint32_t width, uint32_t height, std::span<const uint8_t> marked) {
    std::vector<int64_t> squared(marked.size());
    if (std::find_if(marked.begin(), marked.end(), [](uint8_t m) { return m != 0; }) == marked.end()) {
        std::fill(squared.begin(), squared.end(), kNoBoundary);
        return squared;
    }
    const size_t longer = std::max(width, height);
    std::vector<size_t> vertex(longer);
    std::vector<int64_t> from(longer), result(longer), line(height);
    for (uint32_t x = 0; x < width; ++x) {
        for (uint32_t y = 0; y < height; ++y) line[y] = marked[size_t(y) * width + x] ? 0 : kFar;
        lowerEnvelope(line, vertex, from, result);
        for (uint32_t y = 0; y < height; ++y) squared[size_t(y) * width + x] = line[y];
    }
    line.resize(width);
    for (uint32_t y = 0; y < height; ++y) {
        const auto row = squared.begin() + ptrdiff_t(size_t(y) * width);
        std::copy(row, row + width, line.begin());
        lowerEnvelope(line, vertex, from, result);
        std::copy(line.begin(), line.end(), row);
    }
    return squared;
}

DistanceHistogram distanceHistogram(std::span<const uint32_t> pixels, std::span<const int64_t> squared, double farthest) {
    DistanceHistogram histogram;
    for (const uint32_t pixel : pixels) {
        const double distance = squared[pixel] == kNoBoundary ? farthest : std::sqrt(double(squared[pixel]));
        size_t bin = 0;
        for (uint64_t end = 1; double(end) <= distance; end *= 2) ++bin;
        if (histogram.samples.size() <= bin) histogram.samples.resize(bin + 1, 0);
        ++histogram.samples[bin];
        histogram.max = std::max(histogram.max, distance);
        histogram.mean += distance / double(pixels.size());
    }
    for (size_t bin = 0; bin < histogram.samples.size(); ++bin) histogram.lowerEnds.push_back(bin == 0 ? 0 : uint64_t(1) << (bin - 1));
    return histogram;
}

}  // namespace gno::study
