// SPDX-License-Identifier: MIT
#include "scenes/generator/mesh.hpp"

#include <utility>

namespace gno::scenes {

Placement at(const glm::dvec3& offset) { return {glm::dmat3(1.0), offset}; }

Placement at(const glm::dvec3& offset, const glm::dquat& rotation, const glm::dvec3& scale) {
    glm::dmat3 linear = glm::mat3_cast(rotation);
    for (int column = 0; column < 3; ++column) linear[column] *= scale[column];
    return {linear, offset};
}

uint32_t Mesh::vertex(const glm::dvec3& position) {
    positions.emplace_back(position);
    return static_cast<uint32_t>(positions.size() - 1);
}

void Mesh::triangle(uint32_t a, uint32_t b, uint32_t c) { indices.insert(indices.end(), {a, b, c}); }

void Mesh::quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    triangle(a, b, c);
    triangle(a, c, d);
}

void Mesh::append(const Mesh& other, const Placement& placement) {
    const auto base = static_cast<uint32_t>(positions.size());
    const bool mirrored = glm::determinant(placement.linear) < 0;
    for (const glm::vec3& p : other.positions) vertex(placement(glm::dvec3(p)));
    for (size_t i = 0; i < other.indices.size(); i += 3) {
        uint32_t b = other.indices[i + 1];
        uint32_t c = other.indices[i + 2];
        if (mirrored) std::swap(b, c);
        triangle(base + other.indices[i], base + b, base + c);
    }
}

}  // namespace gno::scenes
