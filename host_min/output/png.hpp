// SPDX-License-Identifier: MIT
// PNG files, 8 bits a channel.
#pragma once
#include <cstdint>
#include <filesystem>

#include "host_min/output/image.hpp"

namespace gno::host {

/// Both throw InputError or WorkError like AtomicFile.
void writePng(const std::filesystem::path& path, const Picture& picture);
void writeGrayPng(const std::filesystem::path& path, const Raster<uint8_t>& picture);

}  // namespace gno::host
