// SPDX-License-Identifier: MIT
// A picture in memory.
#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

namespace gno::host {

/// width x height values, row 0 on top, rows without padding.
template <class T>
struct Raster {
    uint32_t width = 0, height = 0;
    std::vector<T> pixels;

    Raster() = default;
    Raster(uint32_t w, uint32_t h, const T& value = T{}) : width(w), height(h), pixels(std::size_t{w} * h, value) {}
    /// Takes values that are already there; their number must be w * h.
    Raster(uint32_t w, uint32_t h, std::vector<T> values) : width(w), height(h), pixels(std::move(values)) {}

    [[nodiscard]] T& at(uint32_t x, uint32_t y) { return pixels[std::size_t{y} * width + x]; }
    [[nodiscard]] const T& at(uint32_t x, uint32_t y) const { return pixels[std::size_t{y} * width + x]; }
    [[nodiscard]] std::size_t size() const { return pixels.size(); }
};

using Picture = Raster<glm::u8vec3>;  ///< sRGB, 8 bits a channel

}  // namespace gno::host
