// SPDX-License-Identifier: MIT
// PNG files made in a test, byte by byte: 8-bit channels, one stored (not compressed) deflate block.
#pragma once
#include <cstdint>
#include <string>

namespace gno::host::test {

inline std::string bigEndian(uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>(value >> shift & 0xFF));
    return bytes;
}

inline std::string pngChunk(const std::string& type, const std::string& data) {
    uint32_t crc = 0xFFFFFFFFu;
    for (const char c : type + data) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0u);
    }
    return bigEndian(static_cast<uint32_t>(data.size())) + type + data + bigEndian(~crc);
}

/// `texels`: width * height times as many bytes as `channels` (1: grey, 2: grey and alpha, 3: RGB, 4: RGBA).
inline std::string tinyPng(uint32_t width, uint32_t height, const std::string& texels, size_t channels = 4) {
    std::string raw;
    for (uint32_t row = 0; row < height; ++row) raw += '\0' + texels.substr(row * width * channels, width * channels);
    uint32_t a = 1, b = 0;
    for (const char c : raw) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    const auto length = static_cast<uint16_t>(raw.size());
    const auto low = [](uint32_t value) { return std::string{static_cast<char>(value & 0xFF), static_cast<char>(value >> 8 & 0xFF)}; };
    const std::string kinds("\0\0\4\2\6", 5);
    const std::string stored = std::string("\x78\x01\x01", 3) + low(length) + low(0xFFFFu ^ length) + raw + bigEndian(b << 16 | a);
    return "\x89PNG\r\n\x1a\n" + pngChunk("IHDR", bigEndian(width) + bigEndian(height) + '\x08' + kinds[channels] + std::string(3, '\0')) +
           pngChunk("IDAT", stored) + pngChunk("IEND", "");
}

}  // namespace gno::host::test
