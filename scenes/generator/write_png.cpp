// SPDX-License-Identifier: MIT
#include <algorithm>

#include "scenes/generator/glb.hpp"

namespace gno::scenes {
namespace {

std::string bigEndian(uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>(value >> shift & 0xFF));
    return bytes;
}

std::string chunk(const std::string& type, const std::string& data) {
    uint32_t crc = 0xFFFFFFFFu;
    for (const char c : type + data) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0u);
    }
    return bigEndian(static_cast<uint32_t>(data.size())) + type + data + bigEndian(~crc);
}

/// A zlib stream of stored blocks, 65535 bytes each at most.
std::string stored(const std::string& raw) {
    std::string stream = "\x78\x01";
    for (size_t at = 0; at < raw.size(); at += 65535) {
        const std::string block = raw.substr(at, 65535);
        const auto length = static_cast<uint32_t>(block.size()), inverse = ~length;
        stream.push_back(at + block.size() == raw.size() ? '\1' : '\0');
        for (const uint32_t word : {length, inverse})
            for (const int shift : {0, 8}) stream.push_back(static_cast<char>(word >> shift & 0xFF));
        stream += block;
    }
    uint32_t a = 1, b = 0;  // Adler-32
    for (const char c : raw) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    return stream + bigEndian(b << 16 | a);
}

}  // namespace

std::string encodePng(const Texture& texture) {
    std::string raw;
    for (size_t row = 0; row < texture.height; ++row) {
        const auto first = texture.rgba.begin() + static_cast<std::ptrdiff_t>(row * texture.width * 4);
        raw.push_back('\0');  // no filter
        raw.append(first, first + texture.width * 4);
    }
    const std::string eightBitRgba("\x08\x06\x00\x00\x00", 5);
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", bigEndian(texture.width) + bigEndian(texture.height) + eightBitRgba) + chunk("IDAT", stored(raw)) +
           chunk("IEND", "");
}

}  // namespace gno::scenes
