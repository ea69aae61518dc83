// SPDX-License-Identifier: MIT
#include "host_min/output/heatmap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "host_min/output/text.hpp"

namespace gno::host {

namespace {

/// Nine samples of viridis, the perceptually uniform colour map of matplotlib (S. van der Walt, N. Smith, E. Firing; CC0).
constexpr std::array<std::array<uint8_t, 3>, 9> kViridis = {
    {{68, 1, 84}, {71, 45, 123}, {59, 82, 139}, {44, 114, 142}, {33, 145, 140}, {40, 174, 128}, {94, 201, 98}, {173, 220, 48}, {253, 231, 37}}};
constexpr glm::u8vec3 kInvalid{40, 40, 40}, kPaper{18, 18, 20}, kInk{235, 235, 235}, kFaintInk{160, 160, 165};

bool isValid(std::span<const uint8_t> valid, std::size_t i) { return valid.empty() || valid[i] != 0; }

/// 1, 2 or 5 times a power of ten, so that at most `ticks` of them fit in `maximum`.
uint64_t niceStep(uint32_t maximum, uint32_t ticks) {
    for (uint64_t power = 1;; power *= 10)
        for (const uint64_t factor : {1u, 2u, 5u})
            if (factor * power * ticks >= maximum) return factor * power;
}

void fill(Picture& picture, uint32_t x0, uint32_t y0, uint32_t width, uint32_t height, glm::u8vec3 color) {
    for (uint32_t y = y0; y < std::min(y0 + height, picture.height); ++y)
        for (uint32_t x = x0; x < std::min(x0 + width, picture.width); ++x) picture.at(x, y) = color;
}

/// The colour bar at (x, y) and the numbers under it, none on top of another.
void drawBar(Picture& picture, uint32_t x, uint32_t y, uint32_t width, uint32_t height, uint32_t scale, const HeatMapScale& statistics) {
    for (uint32_t i = 0; i < width; ++i) fill(picture, x + i, y, 1, height, heatColor(static_cast<double>(i) / (width - 1)));
    const uint32_t labelY = y + height + 4 * scale;
    const auto place = [&](uint64_t value) { return static_cast<uint32_t>(static_cast<double>(value) / statistics.hottest * (width - 1)); };
    const auto label = [&](uint64_t value, const std::string& text) {
        const uint32_t textPixels = textWidth(text, scale), at = x + place(value);
        fill(picture, at, y + height, scale, 3 * scale, kInk);
        const uint32_t left = at < x + textPixels / 2 ? x : std::min(at - textPixels / 2, x + width - textPixels);
        drawText(picture, left, labelY, text, scale, kInk);
    };
    const std::string last = statistics.maximum > statistics.hottest ? fmt::format(">= {}", statistics.hottest) : std::to_string(statistics.hottest);
    const uint32_t lastLeft = x + width - std::min(width, textWidth(last, scale));
    label(statistics.hottest, last);
    const uint64_t step = niceStep(statistics.hottest, 6);
    for (uint64_t value = 0; value < statistics.hottest; value += step) {
        const std::string text = std::to_string(value);
        if (x + place(value) + textWidth(text, scale) + 4 * scale < lastLeft) label(value, text);
    }
}

}  // namespace

HeatMapScale heatMapScale(const Raster<uint32_t>& values, std::span<const uint8_t> valid, const HeatMapOptions& options) {
    if (!valid.empty() && valid.size() != values.size()) throw std::invalid_argument("heatMap: as many flags as values are needed");
    std::vector<uint32_t> kept;
    kept.reserve(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        if (isValid(valid, i)) kept.push_back(values.pixels[i]);
    HeatMapScale scale;
    if (!kept.empty()) {
        double sum = 0;
        for (const uint32_t value : kept) {
            scale.maximum = std::max(scale.maximum, value);
            sum += value;
        }
        scale.mean = sum / static_cast<double>(kept.size());
        const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.999 * static_cast<double>(kept.size()))) - 1;
        std::nth_element(kept.begin(), kept.begin() + rank, kept.end());
        scale.hottest = kept[static_cast<std::size_t>(rank)];
    }
    scale.hottest = std::max(1u, options.maximum.value_or(scale.hottest));
    scale.clamped = static_cast<uint64_t>(std::count_if(kept.begin(), kept.end(), [&](uint32_t value) { return value > scale.hottest; }));
    return scale;
}

glm::u8vec3 heatColor(double t) {
    const double place = std::clamp(t, 0.0, 1.0) * (kViridis.size() - 1);
    const std::size_t left = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
    const double share = place - static_cast<double>(left);
    glm::u8vec3 color;
    for (std::size_t c = 0; c < 3; ++c) {
        const double mixed = kViridis[left][c] * (1 - share) + kViridis[left + 1][c] * share;
        color[static_cast<int>(c)] = static_cast<uint8_t>(std::lround(mixed));
    }
    return color;
}

Picture heatMap(const Raster<uint32_t>& values, std::span<const uint8_t> valid, const HeatMapOptions& options) {
    const HeatMapScale statistics = heatMapScale(values, valid, options);
    const std::string unit = options.unit.empty() ? "" : " " + options.unit;
    std::string summary = fmt::format("mean {:.2f}{}, maximum {}{}", statistics.mean, unit, statistics.maximum, unit);
    if (statistics.clamped > 0) summary += fmt::format(", {} pixels above the scale", statistics.clamped);

    const auto textPixels = [&](uint32_t scale) { return std::max(textWidth(options.title, scale), textWidth(summary, scale)) + 16 * scale; };
    const uint32_t width = std::max({values.width, 320u, textPixels(1)});
    uint32_t scale = std::max(1u, width / 480);
    while (scale > 1 && textPixels(scale) > width) --scale;
    const uint32_t margin = 8 * scale, line = textHeight(scale), bar = 14 * scale;
    const uint32_t legend = margin + line + 4 * scale + bar + 6 * scale + line + 2 * scale + line + margin / 2;

    Picture picture(width, values.height + legend, kPaper);
    const uint32_t left = (width - values.width) / 2;
    for (uint32_t y = 0; y < values.height; ++y)
        for (uint32_t x = 0; x < values.width; ++x) {
            const std::size_t i = std::size_t{y} * values.width + x;
            picture.at(left + x, y) = isValid(valid, i) ? heatColor(static_cast<double>(values.pixels[i]) / statistics.hottest) : kInvalid;
        }
    uint32_t y = values.height + margin;
    drawText(picture, margin, y, options.title, scale, kInk);
    y += line + 4 * scale;
    drawBar(picture, margin, y, width - 2 * margin, bar, scale, statistics);
    y += bar + 6 * scale + line + 2 * scale;
    drawText(picture, margin, y, summary, scale, kFaintInk);
    return picture;
}

}  // namespace gno::host
