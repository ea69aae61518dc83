// SPDX-License-Identifier: MIT
#include "host_min/scene/grid.hpp"

#include "host_min/error.hpp"

namespace gno::host {
namespace {

Double3 array(glm::dvec3 v) { return {v.x, v.y, v.z}; }
glm::vec3 vector(const Float3& v) { return {v[0], v[1], v[2]}; }
gno::Grid plain(const Grid& grid) { return {array(grid.origin), grid.exponent}; }
Grid ours(const gno::Grid& grid) { return {{grid.origin[0], grid.origin[1], grid.origin[2]}, grid.exponent}; }

}  // namespace

Grid Grid::around(glm::dvec3 low, glm::dvec3 high) { return ours(gridAround(array(low), array(high))); }

Grid Grid::at(glm::dvec3 origin_, glm::dvec3 low, glm::dvec3 high) { return ours(gridAt(array(origin_), array(low), array(high))); }

double Grid::scale() const { return plain(*this).scale(); }

double Grid::step() const { return std::ldexp(1.0, exponent - kGridBits); }

bool Grid::holds(glm::dvec3 low, glm::dvec3 high) const {
    const glm::dvec3 farthest = glm::max(glm::abs(low - origin), glm::abs(high - origin)) * scale();
    return farthest.x <= 1 && farthest.y <= 1 && farthest.z <= 1;  // and none is NaN
}

glm::vec3 Grid::snap(glm::dvec3 world_) const { return vector(plain(*this).snap(array(world_))); }

glm::dvec3 Grid::world(glm::dvec3 onGrid) const {
    const Double3 result = plain(*this).world(array(onGrid));
    return {result[0], result[1], result[2]};
}

glm::vec3 snapDirection(glm::dvec3 direction) {
    try {
        return vector(gno::snapDirection(array(direction)));
    } catch (const std::invalid_argument& error) {
        throw WorkError(error.what());
    }
}

}  // namespace gno::host
