// SPDX-License-Identifier: MIT
// Stands before tinygltf, which drops or truncates what it does not understand.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace gno::host {

/// Checks a glTF file's JSON text and returns it without what tinygltf need not see (images, textures, extras, foreign extensions).
/// Throws InputError: not JSON, nested too deeply, not glTF 2.0, a required extension we lack, a reference or size that is no whole number
/// in [0, 2^31), a transformation of the wrong length. `ignored` receives the required extensions that concern textures and materials only and are
/// not read; `textureLists` the file's images, textures and samplers as they are, unchecked.
std::string guardJson(std::string_view text, std::vector<std::string>& ignored, nlohmann::json& textureLists);

}  // namespace gno::host
