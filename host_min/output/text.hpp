// SPDX-License-Identifier: MIT
// Short lines of text in pictures: ASCII only, a fixed bitmap font, no anti-aliasing.
#pragma once
#include <cstdint>
#include <string_view>

#include "host_min/output/image.hpp"

namespace gno::host {

/// Pixels that `text` takes at `scale` (1: capitals are 7 pixels high).
[[nodiscard]] uint32_t textWidth(std::string_view text, uint32_t scale);
[[nodiscard]] uint32_t textHeight(uint32_t scale);

/// Draws with the upper left corner at (x, y), clipped to the picture; what is not printable ASCII becomes '?'.
void drawText(Picture& picture, int64_t x, int64_t y, std::string_view text, uint32_t scale, glm::u8vec3 color);

}  // namespace gno::host
