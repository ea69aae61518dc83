// SPDX-License-Identifier: MIT
// Stands before tinygltf, which drops or truncates what it does not understand.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "host_min/scene/notices.hpp"

namespace gno::host {

/// Checks a glTF file's JSON text and returns it without what tinygltf need not see (buffers, images, textures, extras, foreign extensions; channels
/// of animations that aim at nothing that is read). Throws InputError: not JSON, nested too deeply, not glTF 2.0, an extension that is needed and
/// not read, a reference or size that is no whole number in [0, 2^31), a transformation of the wrong length. `notices` receives what is not used;
/// `lists` the file's buffers, images, textures and samplers as they are, unchecked.
std::string guardJson(std::string_view text, Notices& notices, nlohmann::json& lists);

}  // namespace gno::host
