// SPDX-License-Identifier: MIT
#include "host_min/output/png.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "host_min/error.hpp"
#include "host_min/output/atomic_file.hpp"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC  // other libraries carry their own copy
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace gno::host {

namespace {

void writeBytes(const std::filesystem::path& path, uint32_t width, uint32_t height, int channels, const void* pixels, std::size_t count) {
    if (count != std::size_t{width} * height || count == 0)
        throw std::invalid_argument(fmt::format("writePng: {} pixels are not {} x {}", count, width, height));
    AtomicFile file(path);
    const auto append = [](void* target, void* bytes, int size) {
        static_cast<AtomicFile*>(target)->stream().write(static_cast<char*>(bytes), size);
    };
    const int stride = static_cast<int>(width) * channels;
    if (stbi_write_png_to_func(append, &file, static_cast<int>(width), static_cast<int>(height), channels, pixels, stride) == 0)
        throw MemoryError(fmt::format("cannot write '{}': not enough memory to compress it", path.string()));
    file.commit();
}

}  // namespace

void writePng(const std::filesystem::path& path, const Picture& picture) {
    static_assert(sizeof(glm::u8vec3) == 3);
    writeBytes(path, picture.width, picture.height, 3, picture.pixels.data(), picture.size());
}

void writeGrayPng(const std::filesystem::path& path, const Raster<uint8_t>& picture) {
    writeBytes(path, picture.width, picture.height, 1, picture.pixels.data(), picture.size());
}

}  // namespace gno::host
