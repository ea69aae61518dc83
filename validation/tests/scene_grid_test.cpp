// SPDX-License-Identifier: MIT
#include "host_min/scene/grid.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "host_min/error.hpp"

namespace gno::host {
namespace {

const double kStep = std::ldexp(1.0, -kGridBits);

// Half the distance of neighbouring values of the grid near x: fp32's unit in the last place, but never less than 2^-40.
double halfStep(double x) {
    if (x == 0) return kStep / 2;
    return std::max(std::ldexp(1.0, std::ilogb(x) - 23), kStep) / 2;
}

TEST(SnapCoordinate, IsNearestIdempotentAndAMultiple) {
    std::mt19937_64 random(20240611);
    std::uniform_real_distribution<double> uniform(-2, 2), exponent(-60, 0);
    for (int i = 0; i < 200000; ++i) {
        const double value = i % 2 ? uniform(random) : uniform(random) * std::exp2(exponent(random));
        const float snapped = snapCoordinate(value);
        ASSERT_LE(std::abs(snapped - value), halfStep(value)) << value;
        ASSERT_EQ(std::bit_cast<uint32_t>(snapCoordinate(snapped)), std::bit_cast<uint32_t>(snapped)) << value;
        const double steps = std::ldexp(static_cast<double>(snapped), kGridBits);
        ASSERT_EQ(steps, std::nearbyint(steps)) << value;
    }
}

TEST(SnapCoordinate, AgreesOnBothSidesOfTheSwitch) {
    for (double value = std::ldexp(1.0, -18); value < std::ldexp(1.0, -15); value *= 1.0001) {
        const double asMultiple = std::nearbyint(std::ldexp(value, kGridBits)) * kStep;
        if (value < std::ldexp(1.0, -16)) {
            EXPECT_EQ(snapCoordinate(value), static_cast<float>(asMultiple));
        }
        if (value > std::ldexp(1.0, -17)) {
            EXPECT_EQ(snapCoordinate(value), static_cast<float>(value));
        }
    }
}

TEST(SnapCoordinate, NeverGivesNegativeZero) {
    for (const double value : {0.0, -0.0, -kStep / 4, -1e-300, kStep / 4, kStep / 2, -kStep / 2})
        EXPECT_EQ(std::bit_cast<uint32_t>(snapCoordinate(value)), 0u) << value;
    EXPECT_EQ(snapCoordinate(kStep), static_cast<float>(kStep));
    EXPECT_EQ(snapCoordinate(-0.75 * kStep), static_cast<float>(-kStep));
}

TEST(SnapDirection, LargestComponentIsBetweenHalfAndOne) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> exponent(-300, 300);
    for (int i = 0; i < 20000; ++i) {
        const double size = std::pow(10.0, exponent(random));
        const glm::dvec3 direction = glm::dvec3(normal(random), normal(random), normal(random)) * size;
        const glm::vec3 snapped = snapDirection(direction);
        const float largest = std::max({std::abs(snapped.x), std::abs(snapped.y), std::abs(snapped.z)});
        ASSERT_GE(largest, 0.5f);
        ASSERT_LE(largest, 1.0f);
        ASSERT_GT(glm::dot(glm::normalize(glm::dvec3(snapped)), glm::normalize(direction / size)), 1 - 1e-12);
        for (int axis = 0; axis < 3; ++axis) ASSERT_EQ(snapCoordinate(snapped[axis]), snapped[axis]);
    }
    EXPECT_EQ(snapDirection({0, -3, 0}), glm::vec3(0, -0.75f, 0));
    EXPECT_THROW((void)snapDirection({0, 0, 0}), WorkError);
    EXPECT_THROW((void)snapDirection({0, NAN, 0}), WorkError);
}

TEST(Grid, HoldsItsBoxWithRoomAndWithoutWaste) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> uniform(-1, 1), exponent(-250, 250);
    for (int i = 0; i < 20000; ++i) {
        const double size = std::pow(10.0, exponent(random));
        const glm::dvec3 one = glm::dvec3(uniform(random), uniform(random), uniform(random)) * size;
        const glm::dvec3 other = one + glm::dvec3(uniform(random), uniform(random), uniform(random)) * size;
        const Grid grid = Grid::around(glm::min(one, other), glm::max(one, other));
        double largest = 0;
        for (const glm::dvec3& corner : {one, other})
            for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs((corner[axis] - grid.origin[axis]) * grid.scale()));
        ASSERT_LE(largest, 1 - 1.0 / 1024 + 0x1p-17 + 1e-12);
        ASSERT_GT(largest, 0.5 - 1.0 / 1024 - 0x1p-17);
        ASSERT_EQ(grid.scale(), std::ldexp(1.0, -grid.exponent));
    }
}

TEST(Grid, FillsItsRoomExactly) {
    EXPECT_EQ(Grid::around({-1, 0, 0}, {1, 0, 0}).exponent, 1);  // 1 would leave no room
    EXPECT_EQ(Grid::around({-1 + 1.0 / 1024, 0, 0}, {1 - 1.0 / 1024, 0, 0}).exponent, 0);
    EXPECT_EQ(Grid::around({-1e-4, 0, 0}, {1e-4, 0, 0}).exponent, -13);
    EXPECT_EQ(Grid::around({-1e7, -1, -1}, {1e7, 1, 1}).exponent, 24);
}

TEST(Grid, DegenerateBoxesWork) {
    const Grid point = Grid::around({3, 4, 5}, {3, 4, 5});
    EXPECT_EQ(point.snap({3, 4, 5}), glm::vec3(0));
    const Grid flat = Grid::around({0, 7, 0}, {2, 7, 1});
    EXPECT_EQ(flat.exponent, 1);
    EXPECT_EQ(flat.snap({2, 7, 1}), glm::vec3(0.5f, 0, 0.25f));
    const Grid tiny = Grid::around({0, 0, 0}, {5e-324, 0, 0});
    EXPECT_TRUE(std::isfinite(tiny.scale()));
}

TEST(Grid, WorldUndoesSnap) {
    const Grid grid = Grid::around({-10, 1e6, 0}, {30, 1e6 + 8, 1});
    const glm::dvec3 p(12.3456789, 1e6 + 3.14159, 0.5);
    const glm::dvec3 back = grid.world(grid.snap(p));
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(back[axis], p[axis], 20 * 6e-8 + 1e-9);
}

}  // namespace
}  // namespace gno::host
