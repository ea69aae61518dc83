// SPDX-License-Identifier: MIT
// Exact questions about triangles on the grid.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "host_min/scene/scene.hpp"

namespace gno::host {

/// Whether the triangle has no area, decided exactly. Positions are on the grid (multiples of 2^-40 in [-1, 1]).
bool isCollinear(const Triangle& triangle);

/// How many triangles stand in the list before with the same three positions, in any order.
uint64_t countDuplicates(std::span<const Triangle> triangles);

/// Gives equal positions equal numbers 0, 1, … in order of appearance. Positions hold no -0.
class PointWelder {
public:
    void reset(size_t mostPoints);
    uint32_t number(glm::vec3 position);
    [[nodiscard]] const std::vector<glm::vec3>& points() const { return points_; }

private:
    std::vector<uint32_t> table_;
    std::vector<glm::vec3> points_;
};

/// One entry per triangle of a mesh instance (indices of welded points): 1 when front-face culling is legal for it; see weld.cpp.
std::vector<uint8_t> closedTriangles(const std::vector<glm::vec3>& points, std::span<const glm::uvec3> triangles);

}  // namespace gno::host
