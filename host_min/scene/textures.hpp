// SPDX-License-Identifier: MIT
// Base colour textures of materials that are not opaque: sampler, image, and where a triangle's vertices lie in it. Internal to gnomon_scene.
#pragma once
#include <tiny_gltf.h>

#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

#include "host_min/scene/material.hpp"
#include "host_min/scene/notices.hpp"

namespace gno::host {

/// An affine map of texture coordinates (KHR_texture_transform).
struct TextureTransform {
    glm::dmat2 linear{1.0};
    glm::dvec2 offset{0.0};
    [[nodiscard]] glm::dvec2 operator()(glm::dvec2 uv) const { return linear * uv + offset; }
    bool operator==(const TextureTransform&) const = default;
};

/// Reads materials, and opens a image when the first primitive asks for its material: what no caster needs may be missing or broken.
/// All functions throw InputError.
class Textures {
public:
    /// `lists`: the file's images, textures and samplers as JSON (guardJson). `model`, `lists` and `notices` must outlive this.
    Textures(const tinygltf::Model& model, const nlohmann::json& lists, std::filesystem::path folder, Notices& notices);

    /// The material that a primitive names, -1 for the default one, with its image loaded if it needs one. Returns its number.
    uint32_t use(int material);

    [[nodiscard]] const Material& material(uint32_t number) const { return set_->materials[number]; }
    /// Which TEXCOORD_n a material's texture goes by.
    [[nodiscard]] int coordinateSet(uint32_t number) const { return places_[number].set; }

    /// The material with vertex colours (COLOR_0: red, green, blue, alpha; 0 to 1) multiplied in, as far as they decide what passes. Of a triangle
    /// whose vertices differ their mean is taken, and told.
    uint32_t coloured(uint32_t number, const std::array<glm::dvec4, 3>& colours);

    /// Texel coordinates of a triangle's vertices (glsl/core/material.h) from its texture coordinates.
    [[nodiscard]] std::array<glm::ivec2, 3> corners(uint32_t number, const std::array<glm::dvec2, 3>& uv) const;

    /// What was read, once all primitives have asked.
    [[nodiscard]] std::shared_ptr<const MaterialSet> take();

private:
    struct Place {
        int texture = -1, set = 0;
        TextureTransform transform;
        bool used = false;
    };
    struct Sampling {
        Wrap wrapU = Wrap::repeat, wrapV = Wrap::repeat;
        bool linearFilter = true;
        size_t image = 0;
    };
    static void readTransform(const tinygltf::Value& extension, const std::string& what, Place& place);
    static void readTexture(const tinygltf::Value& info, const std::string& what, Place& place);
    void readMaterial(const tinygltf::Material& from, size_t index);
    [[nodiscard]] Sampling samplingOf(const Place& place, uint32_t number) const;
    void loadTexture(uint32_t number);
    void loadTransmission(uint32_t number);
    void tell(const char* what, const std::set<uint32_t>& materials, const char* instead);
    int loadImage(size_t image);
    [[nodiscard]] std::vector<unsigned char> imageBytes(size_t image, const std::string& what) const;

    const tinygltf::Model& model_;
    const nlohmann::json& lists_;
    std::filesystem::path folder_;
    Notices& notices_;
    std::shared_ptr<MaterialSet> set_;
    std::vector<Place> places_;                          ///< of base colour textures, one per material
    std::vector<Place> transmissions_;                   ///< of transmission textures, one per material
    std::map<std::array<float, 5>, uint32_t> coloured_;  ///< material and its colour -> its number
    std::set<uint32_t> uneven_, untinted_;               ///< materials with triangles of several colours; whose transmission texture is not used
    std::map<size_t, int> images_;                       ///< image of the file -> index into MaterialSet::images
    uint64_t texels_ = 0;
};

/// Decodes a PNG or JPEG. Throws InputError that begins with `what`.
TextureImage decodeImage(const std::vector<unsigned char>& bytes, const std::string& what, uint64_t mostTexels);

}  // namespace gno::host
