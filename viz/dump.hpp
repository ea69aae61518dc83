// SPDX-License-Identifier: MIT
// Reads what `gnomon shade --dump` wrote (README.md, "The dump"): one technique's buffers for one frame and light, and all they came from.
#pragma once
#include <array>
#include <cstring>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

namespace gno::viz {

/// Where the frame's camera stands and looks, on the grid.
struct DumpCamera {
    bool perspective = true;
    glm::dvec3 position{0}, right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};
    double yfov = 0.8;  ///< perspective: vertical field of view, radians
    double ymag = 1;    ///< orthographic: half the picture's height, grid units
};

class Dump {
public:
    /// Reads SCENE-lN-fNNN-TECHNIQUE.PRECISION-dump.json; the buffers beside it are opened, and their sizes checked. Throws InputError: not such a
    /// file, a buffer that is missing, truncated, or not as long as its count says, a value that makes no sense.
    static Dump load(const std::filesystem::path& index);

    [[nodiscard]] const std::string& name() const { return name_; }  ///< of the index without "-dump.json"; what is made from it is called after it
    [[nodiscard]] std::string title() const;                         ///< "show_garden, light 0, frame 0: d-psv certified, 640x480"
    [[nodiscard]] std::string technique() const { return record_["technique"]; }
    [[nodiscard]] std::string precision() const { return record_["precision"]; }
    [[nodiscard]] const nlohmann::json& record() const { return record_; }  ///< what --json holds for this run
    [[nodiscard]] uint64_t counter(const std::string& key) const;           ///< throws InputError when the record has none of that name

    [[nodiscard]] uint32_t casterCount() const { return casterCount_; }
    [[nodiscard]] uint32_t width() const { return width_; }
    [[nodiscard]] uint32_t height() const { return height_; }
    [[nodiscard]] glm::vec4 light() const { return light_; }  ///< homogeneous, on the grid
    [[nodiscard]] glm::dvec3 low() const { return low_; }     ///< bounding box of the casters, on the grid
    [[nodiscard]] glm::dvec3 high() const { return high_; }
    [[nodiscard]] const DumpCamera& camera() const { return camera_; }
    [[nodiscard]] double metres() const { return metres_; }  ///< of one grid unit
    [[nodiscard]] glm::dvec3 world(glm::dvec3 onGrid) const { return centre_ + onGrid * metres_; }

    [[nodiscard]] bool has(const std::string& buffer) const { return buffers_.contains(buffer); }
    [[nodiscard]] bool isTraced() const { return has("trace"); }
    [[nodiscard]] glm::uvec2 tracedPixel() const { return traced_; }  ///< of isTraced() only

    /// The records of a buffer. Throws InputError when the dump has none of that name, or one of another size per record (one
    /// of single words may be read as any), or another count (`count` > 0).
    template <class T>
    [[nodiscard]] std::vector<T> read(const std::string& buffer, uint64_t count = 0) const {
        const std::vector<char> bytes = readBytes(buffer, sizeof(T), count);
        std::vector<T> records(bytes.size() / sizeof(T));
        if (!bytes.empty()) std::memcpy(static_cast<void*>(records.data()), bytes.data(), bytes.size());
        return records;
    }
    /// The first record of a buffer that may be longer.
    template <class T>
    [[nodiscard]] T readOne(const std::string& buffer) const {
        T record;
        std::memcpy(static_cast<void*>(&record), readBytes(buffer, sizeof(T), 0, true).data(), sizeof(T));
        return record;
    }
    template <class T>
    [[nodiscard]] std::vector<T> readPerPixel(const std::string& buffer) const {
        return read<T>(buffer, uint64_t(width_) * height_);
    }

private:
    struct Buffer {
        std::filesystem::path file;
        uint64_t words = 0, count = 0;
    };
    [[nodiscard]] std::vector<char> readBytes(const std::string& buffer, size_t recordBytes, uint64_t count, bool mayBeLonger = false) const;

    std::filesystem::path path_;
    std::string name_;
    nlohmann::json record_;
    uint32_t casterCount_ = 0, width_ = 0, height_ = 0;
    glm::vec4 light_{0};
    glm::dvec3 low_{0}, high_{0}, centre_{0};
    double metres_ = 1;
    DumpCamera camera_;
    glm::uvec2 traced_{0};
    std::map<std::string, Buffer> buffers_;
};

}  // namespace gno::viz
