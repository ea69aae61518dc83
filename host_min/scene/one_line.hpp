// SPDX-License-Identifier: MIT
// Words of one-line messages: text of foreign origin (names in a file, paths, messages of a library) made fit for them, and plurals.
#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace gno::host {

namespace one_line {

/// Bytes of the UTF-8 character that begins at text[at]; 0: none does. `code` receives its number.
inline size_t characterLength(std::string_view text, size_t at, uint32_t& code) {
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(at);
    const size_t length = first < 0x80                    ? 1
                          : first >= 0xC2 && first < 0xE0 ? 2
                          : first >= 0xE0 && first < 0xF0 ? 3
                          : first >= 0xF0 && first < 0xF5 ? 4
                                                          : 0;
    if (length == 0 || at + length > text.size()) return 0;
    code = length == 1 ? first : first & (0xFFu >> (length + 1));
    for (size_t i = at + 1; i < at + length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return 0;
        code = code << 6 | (byte(i) & 0x3Fu);
    }
    constexpr uint32_t kLeast[]{0, 0, 0x80, 0x800, 0x10000};
    return code < kLeast[length] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000) ? 0 : length;
}

/// Moves the cursor, ends the line or turns the direction of writing: not to reach a terminal.
inline bool isControl(uint32_t code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

}  // namespace one_line

/// Control characters and bytes that are not UTF-8 become \n, \t or \xNN, blanks at the end go, and what exceeds 200 bytes is cut between
/// characters.
inline std::string oneLine(std::string_view text) {
    constexpr size_t kLongest = 200;
    constexpr const char* kDigits = "0123456789ABCDEF";
    std::string line;
    size_t at = 0;
    while (at < text.size() && line.size() < kLongest) {
        uint32_t code = 0;
        const size_t length = one_line::characterLength(text, at, code);
        if (length > 0 && !one_line::isControl(code)) {
            line += text.substr(at, length);
        } else if (length == 1 && (code == '\n' || code == '\t' || code == '\r')) {
            line += code == '\n' ? "\\n" : code == '\t' ? "\\t" : "\\r";
        } else {
            for (size_t i = 0; i < std::max<size_t>(length, 1); ++i) {
                const auto byte = static_cast<unsigned char>(text[at + i]);
                line += {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 15]};
            }
        }
        at += std::max<size_t>(length, 1);
    }
    const bool isWhole = at == text.size();
    while (!line.empty() && line.back() == ' ') line.pop_back();
    return isWhole ? line : line + "...";
}

/// "1 light", "2 lights".
inline std::string counted(uint64_t count, std::string_view thing) {
    return std::to_string(count) + ' ' + std::string(thing) + (count == 1 ? "" : "s");
}

}  // namespace gno::host
