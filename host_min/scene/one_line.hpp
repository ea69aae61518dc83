// SPDX-License-Identifier: MIT
// Text of foreign origin (names in a file, messages of a library) made fit for a one-line message.
#pragma once
#include <string>
#include <string_view>

namespace gno::host {

/// Control characters become blanks, trailing blanks go, and what exceeds 200 characters is cut.
inline std::string oneLine(std::string_view text) {
    constexpr size_t kLongest = 200;
    std::string line(text.substr(0, kLongest));
    for (char& c : line)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
    while (!line.empty() && line.back() == ' ') line.pop_back();
    return text.size() > kLongest ? line + "..." : line;
}

}  // namespace gno::host
