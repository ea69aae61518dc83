// SPDX-License-Identifier: MIT
// OpenEXR files: one part, ZIP compressed, one channel per LAYER.CHANNEL.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <glm/glm.hpp>

#include "host_min/output/image.hpp"

namespace gno::host {

/// The values of one channel, width * height of them, row 0 on top. float: FLOAT; uint32_t: UINT; uint8_t: HALF (exact for 0 .. 255).
using ExrPixels = std::variant<std::vector<float>, std::vector<uint32_t>, std::vector<uint8_t>>;

struct ExrChannel {
    std::string name;  ///< what follows the layer's name and a dot; empty: the channel is called like its layer
    ExrPixels pixels;
};

/// A layer's name may contain dots: layer "d-psv.conservative" with channel "visibility" is "d-psv.conservative.visibility" in the file.
struct ExrLayer {
    std::string name;
    std::vector<ExrChannel> channels;
};

/// A layer NAME.X, NAME.Y, NAME.Z of floats.
[[nodiscard]] ExrLayer exrVectorLayer(std::string name, std::span<const glm::vec3> values);

/// Throws InputError or WorkError like AtomicFile, and std::invalid_argument when a channel has the wrong number of values or a name comes twice.
void writeExr(const std::filesystem::path& path, uint32_t width, uint32_t height, std::span<const ExrLayer> layers);

struct ExrFile {
    uint32_t width = 0, height = 0;
    std::map<std::string, ExrPixels> channels;  ///< by full name; HALF channels arrive as float
};

/// Any scan-line or tiled single-part file. Throws InputError: missing, damaged, or no EXR.
[[nodiscard]] ExrFile readExr(const std::filesystem::path& path);

}  // namespace gno::host
