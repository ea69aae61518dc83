// SPDX-License-Identifier: MIT
// From a path to tinygltf's model: the file is read and its outer form checked here; what the model refers to is checked by whoever reads it.
#pragma once
#include <tiny_gltf.h>

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host_min/scene/notices.hpp"

namespace gno::host {

/// Reads a .glb or .gltf file (told apart by their first bytes) with its buffers; images are left alone. A buffer that refers to no bytes is empty.
/// Throws InputError without the path in its text. `notices` and `lists`: see guardJson.
tinygltf::Model openGltf(const std::filesystem::path& path, Notices& notices, nlohmann::json& lists);

/// Where the files lie that a model refers to.
std::filesystem::path folderOf(const std::filesystem::path& model);

/// Throws InputError without the path in its text: no such file, not a regular one, empty, larger than 4 GiB, not readable.
std::vector<unsigned char> readWholeFile(const std::filesystem::path& path);

}  // namespace gno::host
