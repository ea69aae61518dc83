// SPDX-License-Identifier: MIT
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <set>

#include "host_min/error.hpp"
#include "scenes/generator/glb.hpp"

namespace gno::scenes {
namespace {

using Corner = std::array<float, 3>;

Corner corner(const glm::vec3& p) { return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}; }  // + 0 makes -0 equal to 0 bit by bit

bool hasArea(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 u = glm::dvec3(b) - glm::dvec3(a);
    const glm::dvec3 v = glm::dvec3(c) - glm::dvec3(a);
    const glm::dvec3 n = glm::cross(u, v);
    return glm::dot(n, n) > 1e-14 * glm::dot(u, u) * glm::dot(v, v);
}

class Reader {
public:
    explicit Reader(const std::filesystem::path& path) : path_(path) {
        std::string error;
        std::string warning;
        tinygltf::TinyGLTF loader;
        if (!loader.LoadBinaryFromFile(&file_, &error, &warning, path.string()))
            throw host::InputError("cannot read " + path.string() +
                                   ": run from the repository's root or give --models, the folder of the shipped models");
    }

    ShippedModel read() {
        ShippedModel out;
        for (const auto& material : file_.materials) out.materialNames.push_back(material.name);
        for (const tinygltf::Node& node : file_.nodes) {
            const bool moved = !node.matrix.empty() || !node.translation.empty() || !node.rotation.empty() || !node.scale.empty();
            if (moved || !node.children.empty()) throw host::InputError(path_.string() + " has node transforms: shipped models have none");
            if (node.mesh < 0) continue;
            const tinygltf::Mesh& mesh = file_.meshes.at(static_cast<size_t>(node.mesh));
            Model model;
            model.name = mesh.name;
            for (const tinygltf::Primitive& primitive : mesh.primitives) model.parts.push_back(part(primitive));
            std::erase_if(model.parts, [](const Part& p) { return p.mesh.indices.empty(); });
            if (!model.parts.empty()) out.models.push_back(std::move(model));
        }
        return out;
    }

private:
    const std::filesystem::path path_;
    tinygltf::Model file_;
    std::set<std::array<Corner, 3>> seen_;

    const unsigned char* data(const tinygltf::Accessor& accessor, size_t bytes) const {
        const tinygltf::BufferView& view = file_.bufferViews.at(static_cast<size_t>(accessor.bufferView));
        const auto& buffer = file_.buffers.at(static_cast<size_t>(view.buffer)).data;
        const size_t offset = view.byteOffset + accessor.byteOffset;
        if (view.byteStride != 0 || offset > buffer.size() || accessor.count * bytes > buffer.size() - offset)
            throw host::InputError(path_.string() + ": an accessor is interleaved or leaves its buffer");
        return buffer.data() + offset;
    }

    std::vector<uint32_t> indices(const tinygltf::Accessor& accessor) const {
        std::vector<uint32_t> out(accessor.count);
        if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) {
            std::vector<uint16_t> narrow(accessor.count);
            std::memcpy(narrow.data(), data(accessor, 2), accessor.count * 2);
            std::copy(narrow.begin(), narrow.end(), out.begin());
        } else if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
            std::memcpy(out.data(), data(accessor, 4), accessor.count * 4);
        } else {
            throw host::InputError(path_.string() + ": indices must be 16 or 32 bits wide");
        }
        return out;
    }

    Part part(const tinygltf::Primitive& primitive) {
        const auto found = primitive.attributes.find("POSITION");
        if (primitive.mode != TINYGLTF_MODE_TRIANGLES || primitive.indices < 0 || found == primitive.attributes.end())
            throw host::InputError(path_.string() + ": a shipped model holds indexed triangles only");
        const tinygltf::Accessor& accessor = file_.accessors.at(static_cast<size_t>(found->second));
        std::vector<glm::vec3> positions(accessor.count);
        std::memcpy(positions.data(), data(accessor, 12), accessor.count * 12);
        const std::vector<uint32_t> all = indices(file_.accessors.at(static_cast<size_t>(primitive.indices)));

        Part out;
        out.material = primitive.material >= 0 ? static_cast<uint32_t>(primitive.material) : 0;
        std::map<Corner, uint32_t> welded;
        auto vertex = [&](uint32_t i) {
            const glm::vec3& p = positions.at(i);
            const auto [entry, added] = welded.try_emplace(corner(p), static_cast<uint32_t>(out.mesh.positions.size()));
            if (added) out.mesh.positions.push_back(p);
            return entry->second;
        };
        for (size_t i = 0; i + 2 < all.size(); i += 3) {
            const glm::vec3& a = positions.at(all[i]);
            const glm::vec3& b = positions.at(all[i + 1]);
            const glm::vec3& c = positions.at(all[i + 2]);
            std::array<Corner, 3> key{corner(a), corner(b), corner(c)};
            std::sort(key.begin(), key.end());
            if (!hasArea(a, b, c) || !seen_.insert(key).second) continue;
            const uint32_t first = vertex(all[i]);
            const uint32_t second = vertex(all[i + 1]);
            out.mesh.triangle(first, second, vertex(all[i + 2]));
        }
        return out;
    }
};

}  // namespace

ShippedModel readShippedModel(const std::filesystem::path& path) { return Reader(path).read(); }

}  // namespace gno::scenes
