// SPDX-License-Identifier: MIT
#include "host_min/scene/grid.hpp"

#include <algorithm>
#include <cmath>

#include "host_min/error.hpp"

namespace gno::host {

namespace {

constexpr double kRoom = 1.0 / 1024;  // what stays free between the scene and the borders of [-1, 1]
constexpr int kCentreBits = 16;
constexpr int kSmallestExponent = -1000;  // 2^1000 is still a double

double largest(glm::dvec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}  // namespace

// The centre is the middle of the box, rounded to a multiple of 2^(exponent - 16): a scene moved by a large power of two keeps its grid positions
// bit by bit, and coordinates that are multiples of such a step lose nothing. It moves by 2^-17 grid units at most, out of the room to spare.
Grid Grid::around(glm::dvec3 low, glm::dvec3 high) {
    Grid grid;
    grid.centre = low * 0.5 + high * 0.5;
    const double half = std::max(largest(high - grid.centre), largest(grid.centre - low));
    if (half > 0) {
        int exponent = 0;
        const double mantissa = std::frexp(half, &exponent);  // half = mantissa * 2^exponent, mantissa in [0.5, 1)
        grid.exponent = std::max(mantissa <= 1 - kRoom ? exponent : exponent + 1, kSmallestExponent);
        const int step = grid.exponent - kCentreBits;
        for (int axis = 0; axis < 3; ++axis) grid.centre[axis] = std::ldexp(std::nearbyint(std::ldexp(grid.centre[axis], -step)), step);
    }
    return grid;
}

double Grid::scale() const { return std::ldexp(1.0, -exponent); }

glm::vec3 Grid::snap(glm::dvec3 world_) const {
    const glm::dvec3 onGrid = (world_ - centre) * scale();
    return {snapCoordinate(onGrid.x), snapCoordinate(onGrid.y), snapCoordinate(onGrid.z)};
}

glm::dvec3 Grid::world(glm::dvec3 onGrid) const { return centre + onGrid * std::ldexp(1.0, exponent); }

float snapCoordinate(double value) {
    // From 2^-17 on, an fp32 number is a multiple of 2^-40 by itself; below 2^-16, a multiple of 2^-40 has at most 24 bits and is an fp32 number.
    constexpr double kStep = 1.0 / (1ull << kGridBits);
    constexpr double kFloatIsEnough = 1.0 / (1 << 16);
    if (std::abs(value) < kFloatIsEnough) value = std::nearbyint(value * (1ull << kGridBits)) * kStep;
    return static_cast<float>(value) + 0.0f;  // -0 + 0 = +0
}

glm::vec3 snapDirection(glm::dvec3 direction) {
    const double length = largest(direction);
    if (!(length > 0) || !std::isfinite(length)) throw WorkError("a direction must be finite and must not be zero");
    int exponent = 0;
    (void)std::frexp(length, &exponent);
    const auto coordinate = [exponent](double value) { return snapCoordinate(std::ldexp(value, -exponent)); };
    return {coordinate(direction.x), coordinate(direction.y), coordinate(direction.z)};
}

}  // namespace gno::host
