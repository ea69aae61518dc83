// SPDX-License-Identifier: MIT
// What a buffer or an image refers to: a file beside the model, or bytes in the URI itself (RFC 3986, RFC 2397).
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gno::host {

/// %20 and the like; what is no escape stays as it is, and so does '+'.
std::string percentDecoded(std::string_view text);

/// The bytes of a data URI with any media type and parameters, base64 or percent-encoded; nullopt when `uri` is none. Letter case of scheme and
/// "base64" does not matter. Throws InputError when its data are broken.
std::optional<std::vector<unsigned char>> dataUriBytes(std::string_view uri);

/// The bytes that `uri` stands for; files lie in `folder`. Throws InputError that begins with `what` and names the file as the URI has it.
std::vector<unsigned char> readUri(const std::filesystem::path& folder, const std::string& uri, const std::string& what);

}  // namespace gno::host
