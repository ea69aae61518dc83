// SPDX-License-Identifier: MIT
// Indexed triangles while a scene is being built.
#pragma once
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace gno::scenes {

/// An affine map. Points go through `linear` first, then `offset` is added.
struct Placement {
    glm::dmat3 linear{1.0};
    glm::dvec3 offset{0};

    [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& p) const { return linear * p + offset; }
};

Placement at(const glm::dvec3& offset);
Placement at(const glm::dvec3& offset, const glm::dquat& rotation, const glm::dvec3& scale = glm::dvec3(1));

/// Counter-clockwise triangles seen from outside. Positions are rounded to fp32 as they come in, so equal positions stay equal.
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<uint32_t> indices;  ///< three a triangle
    std::vector<glm::vec2> uv;      ///< texture coordinates, one per position; empty: none. Only the meshes that have a texture fill them

    [[nodiscard]] size_t triangleCount() const { return indices.size() / 3; }
    uint32_t vertex(const glm::dvec3& position);
    void triangle(uint32_t a, uint32_t b, uint32_t c);
    void quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d);  ///< split along a - c
    /// Copies `other` through `placement`; a mirroring placement has its winding turned, so outside stays outside.
    void append(const Mesh& other, const Placement& placement);
};

}  // namespace gno::scenes
