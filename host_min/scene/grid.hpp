// SPDX-License-Identifier: MIT
// The scene's grid in GLM's types; what it is and how positions get onto it stands in glsl/core/grid.hpp.
#pragma once
#include <glm/glm.hpp>

#include "glsl/core/grid.hpp"

namespace gno::host {

using gno::kGridBits;
using gno::snapCoordinate;

/// grid position = (world position - origin) * 2^-exponent, rounded to fp32 and to multiples of 2^-kGridBits.
struct Grid {
    glm::dvec3 origin{0.0};
    int exponent = 0;

    /// The grid around the middle of the box [low, high] (world units, finite) whose [-1, 1] holds it with a little room to spare.
    static Grid around(glm::dvec3 low, glm::dvec3 high);
    /// The same around `origin`, rounded to a coarse step (gridAt of glsl/core/grid.hpp).
    static Grid at(glm::dvec3 origin, glm::dvec3 low, glm::dvec3 high);

    [[nodiscard]] glm::vec3 snap(glm::dvec3 world) const;             ///< world position to grid position
    [[nodiscard]] glm::dvec3 world(glm::dvec3 onGrid) const;          ///< grid position to world position
    [[nodiscard]] double scale() const;                               ///< 2^-exponent, grid units per world unit
    [[nodiscard]] double step() const;                                ///< 2^(exponent - kGridBits): positions are multiples of it; world units
    [[nodiscard]] bool holds(glm::dvec3 low, glm::dvec3 high) const;  ///< the box lies in [-1, 1]
    bool operator==(const Grid&) const = default;
};

/// A direction of any length but zero to its own power-of-two grid: largest component in [0.5, 1], multiples of 2^-kGridBits. Throws WorkError for
/// zero.
glm::vec3 snapDirection(glm::dvec3 direction);

}  // namespace gno::host
