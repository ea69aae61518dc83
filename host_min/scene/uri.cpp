// SPDX-License-Identifier: MIT
#include "host_min/scene/uri.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "host_min/error.hpp"
#include "host_min/scene/gltf_file.hpp"
#include "host_min/scene/one_line.hpp"

namespace gno::host {

namespace {

namespace fs = std::filesystem;

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

bool equalsWithoutCase(std::string_view text, std::string_view lowerCase) {
    return std::equal(text.begin(), text.end(), lowerCase.begin(), lowerCase.end(), [](char a, char b) { return lower(a) == b; });
}

int hexDigit(std::string_view text, size_t at) {
    if (at >= text.size()) return -1;
    const char c = lower(text[at]);
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

std::array<int8_t, 256> base64Table() {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<int8_t, 256> table;
    table.fill(-1);
    for (size_t i = 0; i < kDigits.size(); ++i) table[static_cast<unsigned char>(kDigits[i])] = static_cast<int8_t>(i);
    return table;
}

// White space is passed over; the padding may be missing, but neither be too long nor stand inside.
std::vector<unsigned char> base64Decoded(std::string_view text) {
    static const std::array<int8_t, 256> values = base64Table();
    std::vector<unsigned char> bytes;
    bytes.reserve(text.size() / 4 * 3 + 3);
    uint32_t group = 0;
    size_t digits = 0, padding = 0;
    for (const char c : text) {
        if (std::isspace(static_cast<unsigned char>(c))) continue;
        if (c == '=') {
            ++padding;
            continue;
        }
        const int8_t value = values[static_cast<unsigned char>(c)];
        if (value < 0) throw InputError("its base64 holds a character that is none of base64");
        if (padding > 0) throw InputError("its base64 goes on behind its padding");
        group = group << 6 | static_cast<uint32_t>(value);
        if (++digits % 4 != 0) continue;
        for (int shift = 16; shift >= 0; shift -= 8) bytes.push_back(static_cast<unsigned char>(group >> shift & 0xFF));
        group = 0;
    }
    const size_t rest = digits % 4;
    if (rest == 1 || (padding > 0 && (rest == 0 || rest + padding != 4))) throw InputError("its base64 is truncated");
    if (rest >= 2) bytes.push_back(static_cast<unsigned char>(group >> (rest == 2 ? 4 : 10) & 0xFF));
    if (rest == 3) bytes.push_back(static_cast<unsigned char>(group >> 2 & 0xFF));
    return bytes;
}

bool hasScheme(std::string_view uri) {  // one letter is a drive of another system
    const size_t colon = uri.find(':');
    return colon != uri.npos && colon > 1 && std::isalpha(static_cast<unsigned char>(uri[0])) &&
           std::all_of(uri.begin(), uri.begin() + static_cast<std::ptrdiff_t>(colon),
                       [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '+' || c == '-' || c == '.'; });
}

}  // namespace

std::string percentDecoded(std::string_view text) {
    std::string decoded;
    decoded.reserve(text.size());
    for (size_t i = 0; i < text.size(); ++i) {
        const int high = text[i] == '%' ? hexDigit(text, i + 1) : -1, low = text[i] == '%' ? hexDigit(text, i + 2) : -1;
        const bool isEscape = high >= 0 && low >= 0;
        decoded.push_back(isEscape ? static_cast<char>(high * 16 + low) : text[i]);
        if (isEscape) i += 2;
    }
    return decoded;
}

std::optional<std::vector<unsigned char>> dataUriBytes(std::string_view uri) {
    constexpr std::string_view kScheme = "data:";
    if (!equalsWithoutCase(uri.substr(0, kScheme.size()), kScheme)) return std::nullopt;
    const size_t comma = uri.find(',');
    if (comma == uri.npos) throw InputError("its data URI has no comma, and so no data");
    const std::string_view head = uri.substr(kScheme.size(), comma - kScheme.size());
    const size_t last = head.rfind(';');
    std::string word(last == head.npos ? std::string_view() : head.substr(last + 1));
    while (!word.empty() && word.back() == ' ') word.pop_back();
    const std::string data = percentDecoded(uri.substr(comma + 1));
    if (equalsWithoutCase(word, "base64")) return base64Decoded(data);
    return std::vector<unsigned char>(data.begin(), data.end());
}

std::vector<unsigned char> readUri(const fs::path& folder, const std::string& uri, const std::string& what) {
    std::optional<std::vector<unsigned char>> bytes;
    try {
        bytes = dataUriBytes(uri);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", what, error.what()));
    }
    if (bytes) return std::move(*bytes);
    try {
        // As a URI has it; else as the name of a file that looks like one with escapes; else without a query or a fragment.
        const std::string decoded = percentDecoded(uri), withoutQuery = percentDecoded(std::string_view(uri).substr(0, uri.find_first_of("?#")));
        if (decoded.find('\0') != decoded.npos) throw InputError("its name holds a zero byte");
        if (decoded.empty() || fs::path(decoded).is_absolute()) throw InputError("not a path beside the model");
        for (const std::string& name : {decoded, uri, withoutQuery}) {
            std::error_code error;
            if (!name.empty() && fs::exists(folder / name, error)) return readWholeFile(folder / name);
        }
        if (hasScheme(uri)) throw InputError("gnomon reads files beside the model and data URIs, nothing else");
        throw InputError("no such file beside the model");
    } catch (const InputError& error) {
        throw InputError(fmt::format("{} ({}): {}", what, oneLine(uri), error.what()));
    }
}

}  // namespace gno::host
