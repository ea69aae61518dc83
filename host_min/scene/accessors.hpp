// SPDX-License-Identifier: MIT
// Accessors of a glTF file, decoded and checked: every bound is proved before a byte is read or memory is asked for.
#pragma once
#include <tiny_gltf.h>

#include <cstdint>
#include <memory>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace gno::host {

/// Decodes accessors of one model, which must outlive it. All functions throw InputError: index or bytes out of range, a wrong type.
class Accessors {
public:
    explicit Accessors(const tinygltf::Model& model);

    /// All elements, component by component, as numbers (normalised integers become [-1, 1] or [0, 1]; sparse values are in place).
    /// `type` is the one that `what` (words for messages) must have. Decoded once; the reference lives as long as this object.
    const std::vector<double>& values(int accessor, int type, std::string_view what);

    /// The same, for those who keep the numbers: a file may name one accessor many times.
    std::shared_ptr<const std::vector<double>> shared(int accessor, int type, std::string_view what);

    /// The number of elements of an accessor whose bounds hold.
    [[nodiscard]] size_t count(int accessor, std::string_view what) const;

    /// Its type, a TINYGLTF_TYPE_*.
    [[nodiscard]] int type(int accessor, std::string_view what) const;

    /// Unsigned integers of one component each.
    [[nodiscard]] std::vector<uint32_t> indices(int accessor, std::string_view what) const;

private:
    struct Layout {
        const unsigned char* data = nullptr;  ///< null: all zero
        size_t count = 0, stride = 0;
        int components = 0, componentType = 0;
        bool normalized = false;
    };
    [[nodiscard]] Layout layout(int accessor, std::string_view what) const;
    [[nodiscard]] Layout dense(int bufferView, size_t byteOffset, size_t count, int components, int componentType, std::string_view what) const;
    void applySparse(const tinygltf::Accessor& accessor, const Layout& layout, std::vector<double>& values, std::string_view what) const;

    const tinygltf::Model& model_;
    size_t bytes_ = 0;  ///< of all buffers
    size_t decodedNumbers_ = 0;
    std::unordered_map<int, std::shared_ptr<const std::vector<double>>> decoded_;
};

}  // namespace gno::host
