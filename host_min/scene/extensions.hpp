// SPDX-License-Identifier: MIT
// glTF's extensions, in the file's JSON before tinygltf sees it: which are read, which are refused by name, and which are told.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <string_view>

#include "host_min/scene/notices.hpp"

namespace gno::host {

/// Read by this program, wholly or to see that data which it cannot read are not needed.
bool isReadExtension(std::string_view name);

/// Throws InputError when the file requires an extension that changes geometry and is not read.
void checkRequiredExtensions(const nlohmann::json& root);

/// Tells of all that the file names, or `met` (names found in its objects), and that are not read.
void tellOfExtensions(const nlohmann::json& root, const std::set<std::string>& met, Notices& notices);

/// A checked file: throws InputError when a primitive has its data in KHR_draco_mesh_compression alone, and tells of those that need it not.
void checkCompression(const nlohmann::json& root, Notices& notices);

/// A checked file: channels that aim at a node by KHR_animation_pointer become ordinary ones (with "visible" as another path); those that aim at
/// nothing that is read are taken out and told. Throws InputError: a pointer that is no text, or at a node that does not exist.
void resolvePointers(nlohmann::json& root, Notices& notices);

/// The extension by which a buffer view is compressed (EXT_meshopt_compression or its successor), or nullptr.
template <class Extensions>
const char* meshoptOf(const Extensions& extensions) {
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
        if (extensions.find(name) != extensions.end()) return name;
    return nullptr;
}

/// A placeholder for data that decompression would give.
bool isFallbackBuffer(const nlohmann::json& buffer);

}  // namespace gno::host
