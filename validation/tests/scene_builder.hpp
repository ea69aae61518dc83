// SPDX-License-Identifier: MIT
// Small glTF files made in a test, byte by byte, and a folder of their own that goes with the test.
#pragma once
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host_min/error.hpp"
#include "host_min/scene/scene.hpp"

namespace gno::host::test {

using Json = nlohmann::ordered_json;

inline constexpr int kI8 = 5120, kU8 = 5121, kI16 = 5122, kU16 = 5123, kU32 = 5125, kF32 = 5126;

class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "gnomon_scene_XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path_ / name, std::ios::binary) << bytes;
        return path_ / name;
    }

private:
    std::filesystem::path path_;
};

inline std::string word(size_t value) {
    std::string bytes;
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(value >> shift & 0xFF));
    return bytes;
}

inline std::string glbOf(std::string text, std::string binary) {
    text.append((4 - text.size() % 4) % 4, ' ');
    binary.append((4 - binary.size() % 4) % 4, '\0');
    const std::string tail = binary.empty() ? "" : word(binary.size()) + word(0x004E4942) + binary;
    return word(0x46546C67) + word(2) + word(20 + text.size() + tail.size()) + word(text.size()) + word(0x4E4F534A) + text + tail;
}

template <typename T>
std::string bytesOf(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// Collects accessors, meshes and nodes. All functions return the index of what they add.
class Builder {
public:
    Json json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", Json::array()}}}}};
    std::string binary;

    int view(const std::string& bytes, size_t stride = 0) {
        binary.append((4 - binary.size() % 4) % 4, '\0');
        Json entry = {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}};
        if (stride != 0) entry["byteStride"] = stride;
        binary += bytes;
        return add("bufferViews", entry);
    }
    int accessor(int bufferView, int componentType, size_t count, const std::string& type, Json more = Json::object()) {
        Json entry = {{"bufferView", bufferView}, {"componentType", componentType}, {"count", count}, {"type", type}};
        entry.update(more);
        return add("accessors", entry);
    }
    int floats(const std::vector<float>& values, const std::string& type, size_t width) {
        return accessor(view(bytesOf(values)), kF32, values.size() / width, type);
    }
    int positions(const std::vector<float>& values) { return floats(values, "VEC3", 3); }
    int u16(const std::vector<uint16_t>& values) { return accessor(view(bytesOf(values)), kU16, values.size(), "SCALAR"); }
    int mesh(Json primitive) { return add("meshes", {{"primitives", Json::array({primitive})}}); }
    int node(Json entry, bool isRoot = true) {
        const int index = add("nodes", entry);
        if (isRoot) json["scenes"][0]["nodes"].push_back(index);
        return index;
    }
    /// A mesh of these positions (and indices), drawn by a root node of its own.
    int meshNode(const std::vector<float>& values, const std::vector<uint16_t>& indices = {}, Json node_ = Json::object()) {
        Json primitive = {{"attributes", {{"POSITION", positions(values)}}}};
        if (!indices.empty()) primitive["indices"] = u16(indices);
        node_["mesh"] = mesh(primitive);
        return node(node_);
    }
    int add(const std::string& list, const Json& entry) {
        json[list].push_back(entry);
        return static_cast<int>(json[list].size()) - 1;
    }
    [[nodiscard]] std::string glb() const {
        Json whole = json;
        if (!binary.empty()) whole["buffers"][0]["byteLength"] = binary.size();
        return glbOf(whole.dump(), binary);
    }
};

inline const std::vector<float> kTriangle{0, 0, 0, 1, 0, 0, 0, 1, 0};

/// A cube [0, 1]^3, outward normals.
inline const std::vector<float> kCube{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
inline const std::vector<uint16_t> kCubeIndices{0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                                2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};

inline SceneFile loadBytes(const std::string& bytes, const std::string& name = "scene.glb", const std::string& animation = {}) {
    const TemporaryFolder folder;
    return SceneFile::load(folder.write(name, bytes), animation);
}
inline Frame frameOf(const Builder& builder, uint32_t frame = 0, uint32_t camera = 0) { return loadBytes(builder.glb()).evaluate(frame, camera); }

/// What is told of `subject`; empty: nothing.
inline std::string noticeOf(const Frame& frame, const std::string& subject) {
    for (const std::string& notice : frame.facts.notices)
        if (notice.starts_with(subject + ": ")) return notice.substr(subject.size() + 2);
    return {};
}
inline std::string noticeOf(const SceneFile& scene, const std::string& subject) { return noticeOf(scene.evaluate(0, 0), subject); }

/// The frame's triangle in world units.
struct WorldTriangle {
    glm::dvec3 a, b, c;
};
inline WorldTriangle world(const Frame& frame, size_t index) {
    const Triangle& t = frame.triangles.at(index);
    return {frame.grid.world(t.a), frame.grid.world(t.b), frame.grid.world(t.c)};
}

/// The text of the InputError that `work` throws; empty when it throws none.
template <typename Work>
std::string inputError(Work&& work) {
    try {
        work();
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

}  // namespace gno::host::test
