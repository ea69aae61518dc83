// SPDX-License-Identifier: MIT
// The scene's grid: every position that a technique or the oracle sees is an fp32 number in [-1, 1] and a multiple of 2^-40.
// Snapping happens once, in double, before anything else looks at a position (README "What in shadow means").
#pragma once
#include <glm/glm.hpp>

namespace gno::host {

inline constexpr int kGridBits = 40;  ///< positions are multiples of 2^-kGridBits

/// grid position = (world position - centre) * 2^-exponent, rounded to fp32 and to multiples of 2^-kGridBits.
struct Grid {
    glm::dvec3 centre{0.0};
    int exponent = 0;

    /// The grid whose [-1, 1] holds the box [low, high] (world units, finite) with a little room to spare.
    static Grid around(glm::dvec3 low, glm::dvec3 high);

    [[nodiscard]] glm::vec3 snap(glm::dvec3 world) const;     ///< world position to grid position
    [[nodiscard]] glm::dvec3 world(glm::dvec3 onGrid) const;  ///< grid position to world position
    [[nodiscard]] double scale() const;                       ///< 2^-exponent, grid units per world unit
};

/// One coordinate (any finite double in [-2, 2]) to the nearest fp32 multiple of 2^-kGridBits.
float snapCoordinate(double value);

/// A direction of any length but zero to its own power-of-two grid: largest component in [0.5, 1], multiples of 2^-kGridBits.
glm::vec3 snapDirection(glm::dvec3 direction);

}  // namespace gno::host
