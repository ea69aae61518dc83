// SPDX-License-Identifier: MIT
// Pictures of one frame: shaded, visibility mask, difference of two masks, several side by side.
// A visibility raster holds GNO_VISIBILITY_* of glsl/core/shared_types.h: 0 shadow, 1 lit, 2 facing away from the light, 3 background,
// 4 unknown.
#pragma once
#include <cstdint>
#include <span>
#include <string>

#include <glm/glm.hpp>

#include "host_min/output/image.hpp"

namespace gno::host {

inline constexpr glm::u8vec3 kUnknownColor{255, 128, 0};  ///< a sample that the technique had no answer for, in every picture

/// What the pixels show. All rasters have the size of `visibility`; background pixels may hold anything.
struct ShadeInputs {
    const Raster<glm::vec3>& position;   ///< on the grid
    const Raster<glm::vec3>& normal;     ///< unit, geometric, turned to the viewer
    const Raster<glm::vec3>& baseColor;  ///< linear, [0, 1]
    const Raster<uint8_t>& visibility;
    glm::vec4 light;                             ///< homogeneous, on the grid
    glm::vec3 lightColor{1};                     ///< linear; scaled so that its largest component is 1
    glm::vec3 up{0, 1, 0};                       ///< unit, on the grid: where the sky's share of the ambient light comes from
    glm::vec4 viewer{0, 0, 0, 1};                ///< homogeneous, on the grid: for the small share of the light that comes from the viewer
    const Raster<glm::vec3>* passing = nullptr;  ///< share of the light that arrives where the visibility says lit, [0, 1]; null: all of it
};

/// Lambert's law without fall-off, light from sky and ground, background a soft gradient. Unknown samples are orange.
[[nodiscard]] Picture shadePicture(const ShadeInputs& inputs);

/// White: lit, black: in shadow, dark grey: facing away, dark blue: background, orange: unknown; magenta: no visibility.
[[nodiscard]] Picture maskPicture(const Raster<uint8_t>& visibility);

/// Both have one size. Equal pixels: the mask, dimmed. Red: leak (got lit, want shadow). Yellow: false dark (got shadow, want lit).
/// Orange: got unknown. Magenta: else.
[[nodiscard]] Picture differencePicture(const Raster<uint8_t>& got, const Raster<uint8_t>& want);

struct MaskDifference {
    uint64_t wrong = 0;      ///< pixels that differ
    uint64_t leaks = 0;      ///< got lit, want shadow
    uint64_t falseDark = 0;  ///< got shadow, want lit
};
[[nodiscard]] MaskDifference compareMasks(const Raster<uint8_t>& got, const Raster<uint8_t>& want);

/// Pictures from left to right with a gap, aligned on top, one caption (ASCII, may be empty) below each. captions.size() == pictures.size().
[[nodiscard]] Picture beside(std::span<const Picture> pictures, std::span<const std::string> captions);

}  // namespace gno::host
