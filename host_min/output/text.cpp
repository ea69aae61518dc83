// SPDX-License-Identifier: MIT
#include "host_min/output/text.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_easy_font.h>
#pragma GCC diagnostic pop

namespace gno::host {

namespace {

/// stb_easy_font takes a writable string; letters are 7 pixels high with 2 for descenders.
std::string printable(std::string_view text) {
    std::string line(text);
    for (char& c : line)
        if (c < ' ' || c > '~') c = '?';
    return line;
}

}  // namespace

uint32_t textWidth(std::string_view text, uint32_t scale) {
    std::string line = printable(text);
    return static_cast<uint32_t>(stb_easy_font_width(line.data())) * scale;
}

uint32_t textHeight(uint32_t scale) { return 10 * scale; }

void drawText(Picture& picture, int64_t x, int64_t y, std::string_view text, uint32_t scale, glm::u8vec3 color) {
    struct Vertex {
        float x, y, z;
        unsigned char color[4];
    };
    std::string line = printable(text);
    std::vector<Vertex> vertices(line.size() * 40 + 40);  // the font needs at most 8 quads a letter
    const int bytes = static_cast<int>(vertices.size() * sizeof(Vertex));
    const int quads = stb_easy_font_print(0, 0, line.data(), nullptr, vertices.data(), bytes);
    for (int q = 0; q < quads; ++q) {
        const Vertex& low = vertices[static_cast<std::size_t>(q) * 4];
        const Vertex& high = vertices[static_cast<std::size_t>(q) * 4 + 2];
        const auto edge = [&](int64_t origin, float at, uint32_t limit) {
            return std::clamp<int64_t>(origin + static_cast<int64_t>(at) * scale, 0, limit);
        };
        for (int64_t py = edge(y, low.y, picture.height); py < edge(y, high.y, picture.height); ++py)
            for (int64_t px = edge(x, low.x, picture.width); px < edge(x, high.x, picture.width); ++px)
                picture.at(static_cast<uint32_t>(px), static_cast<uint32_t>(py)) = color;
    }
}

}  // namespace gno::host
