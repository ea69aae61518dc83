// SPDX-License-Identifier: MIT
// GLB in and out, by tinygltf. Knows nothing of the host's loader.
#pragma once
#include <filesystem>
#include <string>

#include "scenes/generator/draft.hpp"

namespace gno::scenes {

/// A PNG file, not compressed: the same bytes from every library.
std::string encodePng(const Texture& texture);

/// The bytes of a GLB file of the draft: the same draft gives the same bytes.
std::string encodeGlb(const Draft& draft, const std::string& name);

/// Writes beside `path` and renames. Throws WorkError.
void writeFile(const std::filesystem::path& path, const std::string& bytes);

/// A shipped model: one Model a glTF mesh; `materialNames[part.material]` is the file's name of a part's material. Node transforms are applied.
/// Triangles of zero area and those that repeat an earlier one are left out, vertices stay shared. Throws InputError.
struct ShippedModel {
    std::vector<Model> models;
    std::vector<std::string> materialNames;
};
ShippedModel readShippedModel(const std::filesystem::path& path);

}  // namespace gno::scenes
