// SPDX-License-Identifier: MIT
// What the casters of a scene are made of, as far as light passes through them (the definition: glsl/core/transmittance.glsl).
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace gno::host {

enum class Wrap : uint8_t { repeat, mirrored, clamp };

struct Material {
    enum class Alpha { opaque, mask, blend };
    std::string name;
    Alpha alpha = Alpha::opaque;
    float alphaCutoff = 0.5f;
    glm::vec4 baseColor{0.8f, 0.8f, 0.8f, 1.0f};  ///< linear, glTF baseColorFactor
    float transmission = 0;                       ///< KHR_materials_transmission: its factor
    bool textured = false;                        ///< has a base colour texture
    int image = -1;                               ///< index into MaterialSet::images; -1: none, or an opaque material, whose image nobody needs
    Wrap wrapU = Wrap::repeat, wrapV = Wrap::repeat;
    bool linearFilter = true;  ///< bilinear; otherwise the nearest texel
    bool doubleSided = false;

    /// Nothing passes it anywhere: no image of it is read.
    [[nodiscard]] bool isOpaque() const { return alpha == Alpha::opaque && transmission == 0; }
};

/// An image as in its file: 4 bytes a texel (red, green, blue in sRGB; alpha), rows from the top.
struct TextureImage {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> rgba;
    bool isLinear = false;  ///< red, green and blue are linear, and the transmission texture is multiplied in
};

/// sRGB's own function: c / 12.92 up to 0.04045, ((c + 0.055) / 1.055)^2.4 above, rounded.
inline uint8_t linearChannel(uint8_t srgb) {
    const double c = static_cast<double>(srgb) / 255;
    return static_cast<uint8_t>(std::floor(255 * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4)) + 0.5));
}

struct MaterialSet {
    std::vector<Material> materials;   ///< the file's, glTF's default material, and those with vertex colours multiplied in
    std::vector<TextureImage> images;  ///< those of the materials that are not opaque
};

/// A triangle that is not opaque: where its vertices lie in the image, in 1/256 texel (glsl/core/material.h), 0 without a image.
struct Surface {
    std::array<glm::ivec2, 3> corners{};
    uint32_t material = 0;
};

inline constexpr uint32_t kOpaque = 0xFFFFFFFFu;  ///< Frame::surfaceOf of an opaque triangle; GNO_OPAQUE_CASTER of glsl/core

}  // namespace gno::host
