// SPDX-License-Identifier: MIT
// The one file that holds stb_image: PNG and JPEG, 8 bits a channel (of 16 the upper ones), grey and palettes widened to red, green, blue and alpha.
#include <fmt/format.h>

#include <limits>
#include <memory>

#include "host_min/error.hpp"
#include "host_min/scene/textures.hpp"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC  // other libraries carry their own copy
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 32768
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace gno::host {

TextureImage decodeImage(const std::vector<unsigned char>& bytes, const std::string& what, uint64_t mostTexels) {
    if (bytes.size() > static_cast<size_t>(std::numeric_limits<int>::max())) throw InputError(fmt::format("{} is larger than 2 GiB", what));
    const auto size = static_cast<int>(bytes.size());
    int width = 0, height = 0, channels = 0;
    if (stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) == 0 || width < 1 || height < 1)
        throw InputError(
            fmt::format("{} is not a PNG or JPEG that can be read ({})", what, stbi_failure_reason() ? stbi_failure_reason() : "unknown"));
    if (static_cast<uint64_t>(width) * static_cast<uint64_t>(height) > mostTexels)
        throw InputError(fmt::format("{} has {} x {} texels; all images together may have {}", what, width, height, mostTexels));
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4),
                                                           stbi_image_free);
    if (!pixels) throw InputError(fmt::format("{} is broken or truncated ({})", what, stbi_failure_reason()));
    TextureImage image{static_cast<uint32_t>(width), static_cast<uint32_t>(height), {}};
    image.rgba.assign(pixels.get(), pixels.get() + static_cast<size_t>(width) * static_cast<size_t>(height) * 4);
    return image;
}

}  // namespace gno::host
