// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "host_min/error.hpp"
#include "host_min/scene/scene_data.hpp"

namespace gno::host {

namespace {

// Triangles of a list, strip or fan of `count` vertices, as indices into that sequence. Strips keep their winding by swapping every other one.
std::vector<glm::uvec3> triangulate(int mode, uint32_t count) {
    std::vector<glm::uvec3> triangles;
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        triangles.reserve(count / 3);
        for (uint32_t i = 0; i + 2 < count; i += 3) triangles.emplace_back(i, i + 1, i + 2);
    } else if (count >= 3) {
        triangles.reserve(count - 2);
        for (uint32_t i = 0; i + 2 < count; ++i) {
            if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
                triangles.emplace_back(0, i + 1, i + 2);
            else
                triangles.emplace_back(i, i + 1 + i % 2, i + 2 - i % 2);
        }
    }
    return triangles;
}

// Renumbers the triangles' vertices 0, 1, … in order of first use; returns the vertices kept.
std::vector<uint32_t> keepUsed(std::vector<glm::uvec3>& triangles, size_t vertexCount, const std::string& what) {
    // Many primitives may share one large accessor: the table is kept, and only what was used is reset.
    static thread_local std::vector<uint32_t> newIndex;
    constexpr uint32_t kUnused = 0xFFFFFFFFu;
    if (newIndex.size() < vertexCount) newIndex.resize(vertexCount, kUnused);
    for (const glm::uvec3& triangle : triangles)
        for (int corner = 0; corner < 3; ++corner)
            if (triangle[corner] >= vertexCount)
                throw InputError(fmt::format("{}: index {} is past its {} vertices", what, triangle[corner], vertexCount));
    std::vector<uint32_t> kept;
    for (glm::uvec3& triangle : triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            uint32_t& renumbered = newIndex[triangle[corner]];
            if (renumbered == kUnused) {
                renumbered = static_cast<uint32_t>(kept.size());
                kept.push_back(triangle[corner]);
            }
            triangle[corner] = renumbered;
        }
    }
    for (const uint32_t vertex : kept) newIndex[vertex] = kUnused;
    return kept;
}

std::vector<glm::dvec3> gather(const std::vector<double>& values, const std::vector<uint32_t>& kept, const std::string& what) {
    std::vector<glm::dvec3> result(kept.size());
    for (size_t i = 0; i < kept.size(); ++i) {
        const double* value = values.data() + size_t{kept[i]} * 3;
        result[i] = {value[0], value[1], value[2]};
        if (!(std::isfinite(value[0]) && std::isfinite(value[1]) && std::isfinite(value[2])))
            throw InputError(fmt::format("{}: the position of vertex {} is not finite", what, kept[i]));
    }
    return result;
}

int attribute(const std::map<std::string, int>& attributes, const char* name) {
    const auto found = attributes.find(name);
    return found == attributes.end() ? -1 : found->second;
}

std::vector<glm::uvec3> readTriangles(const tinygltf::Primitive& primitive, const Accessors& accessors, size_t vertexCount,
                                      const std::string& what) {
    if (primitive.indices < 0) {
        if (vertexCount > kMostTriangles * 3) throw InputError(fmt::format("{} has too many vertices", what));
        return triangulate(primitive.mode, static_cast<uint32_t>(vertexCount));
    }
    const std::vector<uint32_t> indices = accessors.indices(primitive.indices, what + " indices");
    // What makes no triangle (a rest of one or two indices) is checked as well.
    for (const uint32_t index : indices)
        if (index >= vertexCount) throw InputError(fmt::format("{}: index {} is past its {} vertices", what, index, vertexCount));
    std::vector<glm::uvec3> triangles = triangulate(primitive.mode, static_cast<uint32_t>(indices.size()));
    for (glm::uvec3& triangle : triangles) triangle = {indices[triangle.x], indices[triangle.y], indices[triangle.z]};
    return triangles;
}

// Texel coordinates of a primitive's triangles, for a material that is not opaque; all 0 where it has no image.
std::vector<std::array<glm::ivec2, 3>> readCorners(const tinygltf::Primitive& primitive, Accessors& accessors, const Textures& textures,
                                                   uint32_t material, const std::vector<glm::uvec3>& triangles, size_t vertexCount,
                                                   const std::string& what) {
    std::vector<std::array<glm::ivec2, 3>> corners(triangles.size());
    if (textures.material(material).image < 0) return corners;
    const std::string name = fmt::format("TEXCOORD_{}", textures.coordinateSet(material));
    const int index = attribute(primitive.attributes, name.c_str());
    if (index < 0) throw InputError(fmt::format("{} lacks {}, which its material {} needs", what, name, material));
    const std::vector<double>& uv = accessors.values(index, TINYGLTF_TYPE_VEC2, what + " " + name);
    if (uv.size() != vertexCount * 2) throw InputError(fmt::format("{}: {} has {} entries for {} vertices", what, name, uv.size() / 2, vertexCount));
    for (size_t i = 0; i < triangles.size(); ++i) {
        const auto at = [&](uint32_t vertex) { return glm::dvec2(uv[size_t{vertex} * 2], uv[size_t{vertex} * 2 + 1]); };
        const std::array<glm::dvec2, 3> three{at(triangles[i].x), at(triangles[i].y), at(triangles[i].z)};
        for (const glm::dvec2& one : three)
            if (!(std::abs(one.x) <= kLargestNumber && std::abs(one.y) <= kLargestNumber))
                throw InputError(fmt::format("{}: {} is not finite", what, name));
        try {
            corners[i] = textures.corners(material, three);
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}: {}", what, error.what()));
        }
    }
    return corners;
}

// Materials of a primitive's triangles with its vertex colours multiplied in; empty without any.
std::vector<uint32_t> readColours(const tinygltf::Primitive& primitive, Accessors& accessors, Textures& textures, uint32_t material,
                                  const std::vector<glm::uvec3>& triangles, size_t vertexCount, const std::string& what) {
    const int index = attribute(primitive.attributes, "COLOR_0");
    if (index < 0) return {};
    const bool hasAlpha = accessors.type(index, what + " COLOR_0") == TINYGLTF_TYPE_VEC4;
    const std::vector<double>& values = accessors.values(index, hasAlpha ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3, what + " COLOR_0");
    const size_t width = hasAlpha ? 4 : 3;
    if (values.size() != vertexCount * width)
        throw InputError(fmt::format("{}: COLOR_0 has {} entries for {} vertices", what, values.size() / width, vertexCount));
    for (const double value : values)
        if (!(std::abs(value) <= kLargestNumber)) throw InputError(fmt::format("{}: COLOR_0 is not finite", what));
    const auto at = [&](uint32_t vertex) {
        const double* value = values.data() + size_t{vertex} * width;
        return glm::clamp(glm::dvec4(value[0], value[1], value[2], hasAlpha ? value[3] : 1.0), 0.0, 1.0);
    };
    std::vector<uint32_t> coloured;
    coloured.reserve(triangles.size());
    for (const glm::uvec3& t : triangles) coloured.push_back(textures.coloured(material, {at(t.x), at(t.y), at(t.z)}));
    return coloured;
}

PrimitiveData loadPrimitive(const tinygltf::Primitive& primitive, Accessors& accessors, Textures& textures, uint64_t& displacements,
                            const std::string& what) {
    const int position = attribute(primitive.attributes, "POSITION");
    const std::vector<double>& positions = accessors.values(position, TINYGLTF_TYPE_VEC3, what + " POSITION");
    const size_t vertexCount = positions.size() / 3;
    PrimitiveData result;
    result.triangles = readTriangles(primitive, accessors, vertexCount, what);
    result.material = textures.use(primitive.material);
    if (!textures.material(result.material).isOpaque()) {
        result.corners = readCorners(primitive, accessors, textures, result.material, result.triangles, vertexCount, what);
        result.coloured = readColours(primitive, accessors, textures, result.material, result.triangles, vertexCount, what);
    }
    const std::vector<uint32_t> kept = keepUsed(result.triangles, vertexCount, what);
    result.positions = gather(positions, kept, what);
    displacements += uint64_t{kept.size()} * primitive.targets.size();
    if (displacements > kMostDisplacements) throw InputError(fmt::format("{}: its mesh has too many morph targets", what));
    for (const auto& target : primitive.targets) {
        const int displacement = attribute(target, "POSITION");
        if (displacement < 0) {  // it moves normals only
            result.targets.emplace_back();
            continue;
        }
        const std::vector<double>& values = accessors.values(displacement, TINYGLTF_TYPE_VEC3, what + " morph target");
        if (values.size() != vertexCount * 3)
            throw InputError(fmt::format("{}: a morph target has {} vertices, not {}", what, values.size() / 3, vertexCount));
        result.targets.push_back(gather(values, kept, what + " morph target"));
    }
    for (const auto& [name, index] : primitive.attributes)
        if (name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_"))
            if (accessors.count(index, what + " " + name.substr(0, 16)) != vertexCount)
                throw InputError(fmt::format("{}: {} does not have one entry per vertex", what, name.substr(0, 16)));
    loadInfluences(primitive, accessors, kept, result);
    return result;
}

}  // namespace

MeshData loadMesh(const tinygltf::Model& model, size_t index, Accessors& accessors, Textures& textures) {
    const tinygltf::Mesh& mesh = model.meshes[index];
    MeshData result;
    for (size_t i = 0; i < mesh.primitives.size(); ++i) {
        const tinygltf::Primitive& primitive = mesh.primitives[i];
        const std::string what = fmt::format("mesh {} primitive {}", index, i);
        if (primitive.material >= static_cast<int>(model.materials.size()))
            throw InputError(fmt::format("{}: material {} does not exist, there are {}", what, primitive.material, model.materials.size()));
        if (primitive.mode < TINYGLTF_MODE_POINTS || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN)
            throw InputError(fmt::format("{}: mode {} is not glTF", what, primitive.mode));
        if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
            ++result.pointOrLinePrimitives;
            continue;
        }
        if (primitive.attributes.count("POSITION") == 0) continue;  // legal, and draws nothing
        if (result.primitives.empty())
            result.targetCount = primitive.targets.size();
        else if (result.targetCount != primitive.targets.size())
            throw InputError(fmt::format("{} has {} morph targets, others of its mesh have {}", what, primitive.targets.size(), result.targetCount));
        result.primitives.push_back(loadPrimitive(primitive, accessors, textures, result.displacements, what));
        result.triangleCount += result.primitives.back().triangles.size();
        if (result.triangleCount > kMostTriangles) throw InputError(fmt::format("mesh {} has more than {} triangles", index, kMostTriangles));
    }
    result.weights = mesh.weights;
    if (result.weights.empty()) result.weights.assign(result.targetCount, 0.0);
    if (!result.primitives.empty() && result.weights.size() != result.targetCount)
        throw InputError(fmt::format("mesh {} has {} weights for {} morph targets", index, result.weights.size(), result.targetCount));
    for (const double weight : result.weights)
        if (!(std::abs(weight) <= kLargestNumber)) throw InputError(fmt::format("mesh {}: a weight is not finite", index));
    return result;
}

}  // namespace gno::host
