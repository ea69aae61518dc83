// SPDX-License-Identifier: MIT
// From a path to tinygltf's model: the file is read and its outer form checked here; what the model refers to is checked by whoever reads it.
#pragma once
#include <tiny_gltf.h>

#include <filesystem>
#include <string>
#include <vector>

namespace gno::host {

/// Reads a .glb or .gltf file (told apart by their first bytes) with its buffers; images are left alone.
/// Throws InputError without the path in its text. `ignored`: see guardJson.
tinygltf::Model openGltf(const std::filesystem::path& path, std::vector<std::string>& ignored);

}  // namespace gno::host
