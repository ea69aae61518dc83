// SPDX-License-Identifier: MIT
#include <algorithm>
#include <stdexcept>

#include "glsl/core/shared_types.h"
#include "host_min/output/shade_picture.hpp"
#include "host_min/output/text.hpp"

namespace gno::host {

namespace {

constexpr glm::u8vec3 kPaper{250, 250, 250}, kInk{30, 30, 34};

glm::u8vec3 maskColor(uint8_t visibility) {
    switch (visibility) {
        case GNO_VISIBILITY_SHADOW:
            return {0, 0, 0};
        case GNO_VISIBILITY_LIT:
            return {255, 255, 255};
        case GNO_VISIBILITY_FACING_AWAY:
            return {72, 72, 72};
        case GNO_VISIBILITY_BACKGROUND:
            return {46, 62, 96};
        case GNO_VISIBILITY_UNKNOWN:
            return kUnknownColor;
        default:
            return {255, 0, 255};  // a shader wrote what is no visibility
    }
}

glm::u8vec3 differenceColor(uint8_t got, uint8_t want) {
    if (got == want) {
        const glm::u8vec3 full = maskColor(want);
        return {full.x / 4 + 12, full.y / 4 + 12, full.z / 4 + 12};
    }
    if (got == GNO_VISIBILITY_UNKNOWN) return maskColor(got);
    if (got == GNO_VISIBILITY_LIT && want == GNO_VISIBILITY_SHADOW) return {255, 32, 32};
    if (got == GNO_VISIBILITY_SHADOW && want == GNO_VISIBILITY_LIT) return {255, 224, 0};
    return {255, 0, 255};
}

void requireSameSize(const Raster<uint8_t>& got, const Raster<uint8_t>& want) {
    if (got.width != want.width || got.height != want.height) throw std::invalid_argument("two masks of different size cannot be compared");
}

}  // namespace

Picture maskPicture(const Raster<uint8_t>& visibility) {
    Picture picture(visibility.width, visibility.height);
    std::transform(visibility.pixels.begin(), visibility.pixels.end(), picture.pixels.begin(), maskColor);
    return picture;
}

Picture differencePicture(const Raster<uint8_t>& got, const Raster<uint8_t>& want) {
    requireSameSize(got, want);
    Picture picture(got.width, got.height);
    std::transform(got.pixels.begin(), got.pixels.end(), want.pixels.begin(), picture.pixels.begin(), differenceColor);
    return picture;
}

MaskDifference compareMasks(const Raster<uint8_t>& got, const Raster<uint8_t>& want) {
    requireSameSize(got, want);
    MaskDifference difference;
    for (std::size_t i = 0; i < got.size(); ++i) {
        if (got.pixels[i] == want.pixels[i]) continue;
        ++difference.wrong;
        difference.leaks += got.pixels[i] == GNO_VISIBILITY_LIT && want.pixels[i] == GNO_VISIBILITY_SHADOW;
        difference.falseDark += got.pixels[i] == GNO_VISIBILITY_SHADOW && want.pixels[i] == GNO_VISIBILITY_LIT;
    }
    return difference;
}

Picture beside(std::span<const Picture> pictures, std::span<const std::string> captions) {
    if (pictures.empty() || captions.size() != pictures.size()) throw std::invalid_argument("beside: one caption per picture, at least one picture");
    uint32_t tallest = 0, widest = 0;
    for (const Picture& picture : pictures) {
        tallest = std::max(tallest, picture.height);
        widest = std::max(widest, picture.width);
    }
    const bool any = std::any_of(captions.begin(), captions.end(), [](const std::string& caption) { return !caption.empty(); });
    uint32_t scale = std::max(1u, widest / 200);
    const auto fits = [&] {
        for (std::size_t i = 0; i < pictures.size(); ++i)
            if (textWidth(captions[i], scale) > pictures[i].width) return false;
        return true;
    };
    while (scale > 1 && !fits()) --scale;
    const uint32_t gap = 4 * scale;
    uint32_t width = gap;
    for (std::size_t i = 0; i < pictures.size(); ++i) width += std::max(pictures[i].width, textWidth(captions[i], scale)) + gap;
    Picture all(width, gap + tallest + (any ? gap + textHeight(scale) : 0) + gap, kPaper);
    uint32_t left = gap;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const Picture& picture = pictures[i];
        const uint32_t column = std::max(picture.width, textWidth(captions[i], scale));
        for (uint32_t y = 0; y < picture.height; ++y)
            std::copy_n(&picture.at(0, y), picture.width, &all.at(left + (column - picture.width) / 2, gap + y));
        drawText(all, left + (column - textWidth(captions[i], scale)) / 2, gap + tallest + gap, captions[i], scale, kInk);
        left += column + gap;
    }
    return all;
}

}  // namespace gno::host
