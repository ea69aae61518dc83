// SPDX-License-Identifier: MIT
// Pictures: statistics of heat maps, legends, masks, differences. With GNOMON_KEEP_PICTURES=FOLDER the pictures are kept there to be looked at.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <numbers>

#include "host_min/output/heatmap.hpp"
#include "host_min/output/png.hpp"
#include "host_min/output/shade_picture.hpp"
#include "host_min/output/text.hpp"

using namespace gno::host;

namespace {

void keep(const char* name, const Picture& picture) {
    if (const char* folder = std::getenv("GNOMON_KEEP_PICTURES")) writePng(std::filesystem::path(folder) / name, picture);
}

std::size_t countOf(const Picture& picture, glm::u8vec3 color) {
    return static_cast<std::size_t>(std::count(picture.pixels.begin(), picture.pixels.end(), color));
}

Raster<uint32_t> ramp(uint32_t width, uint32_t height) {
    Raster<uint32_t> values(width, height);
    for (std::size_t i = 0; i < values.size(); ++i) values.pixels[i] = static_cast<uint32_t>(i % 100);
    return values;
}

float brightness(glm::u8vec3 c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }

/// A sphere above a floor under a point light, ray cast: what a frame looks like.
struct ToyFrame {
    Raster<glm::vec3> position, normal, color;
    Raster<uint8_t> visibility;
    glm::vec4 light{0.5f, 0.9f, 0.3f, 1}, viewer{0, 0.45f, 1.4f, 1};

    ToyFrame(uint32_t width, uint32_t height) : position(width, height), normal(width, height), color(width, height), visibility(width, height, 3) {
        for (uint32_t y = 0; y < height; ++y)
            for (uint32_t x = 0; x < width; ++x) shoot(x, y);
    }

private:
    static constexpr float kRadius = 0.25f;
    static float sphere(glm::vec3 from, glm::vec3 way) {
        const float b = glm::dot(from, way), c = glm::dot(from, from) - kRadius * kRadius, d = b * b - c;
        return d < 0 ? -1 : -b - std::sqrt(d);
    }
    void shoot(uint32_t x, uint32_t y) {
        const auto w = static_cast<float>(visibility.width), h = static_cast<float>(visibility.height);
        const glm::vec3 eye(viewer);
        const glm::vec3 way = glm::normalize(glm::vec3((static_cast<float>(x) - w / 2) / h, -(static_cast<float>(y) - h / 2) / h - 0.35f, -1.2f));
        const float hit = sphere(eye, way), floorHit = way.y < 0 ? (-kRadius - eye.y) / way.y : -1;
        glm::vec3 p, n, c;
        if (hit > 0) {
            p = eye + way * hit, n = glm::normalize(p), c = {0.75f, 0.3f, 0.2f};
        } else if (floorHit > 0 && floorHit < 4) {
            p = eye + way * floorHit, n = {0, 1, 0}, c = glm::vec3(0.8f);
        } else {
            return;
        }
        position.at(x, y) = p, normal.at(x, y) = n, color.at(x, y) = c;
        const glm::vec3 toLight = glm::vec3(light) - p;
        const bool away = glm::dot(n, toLight) <= 0;
        const bool dark = hit <= 0 && sphere(p, glm::normalize(toLight)) > 0;
        visibility.at(x, y) = away ? 2 : dark ? 0 : 1;
    }
};

}  // namespace

TEST(OutputHeatMap, ScaleTellsTrueMaximumAndClampsAtThePercentile) {
    Raster<uint32_t> values = ramp(100, 100);
    values.at(3, 4) = 5000;
    const HeatMapScale scale = heatMapScale(values, {}, {"t", "nodes", {}});
    EXPECT_EQ(scale.maximum, 5000u);
    EXPECT_EQ(scale.hottest, 99u);
    EXPECT_EQ(scale.clamped, 1u);
    EXPECT_NEAR(scale.mean, (49.5 * 10000 - 3 + 5000) / 10000, 1e-9);  // (3, 4) held 3 before
    std::vector<uint8_t> valid(values.size(), 1);
    valid[4 * 100 + 3] = 0;
    EXPECT_EQ(heatMapScale(values, valid, {}).maximum, 99u);
    EXPECT_EQ(heatMapScale(values, {}, {"t", "nodes", 200u}).hottest, 200u);
    const std::vector<uint8_t> none(values.size(), 0);
    EXPECT_EQ(heatMapScale(values, none, {}).maximum, 0u);
    EXPECT_EQ(heatMapScale(values, none, {}).hottest, 1u);
}

TEST(OutputHeatMap, PixelsHaveTheColoursOfTheirValues) {
    Raster<uint32_t> values(640, 100, 10u);
    values.at(5, 6) = 40;
    values.at(7, 8) = 80;
    std::vector<uint8_t> valid(values.size(), 1);
    valid[9] = 0;
    const Picture picture = heatMap(values, valid, {"d-psv, certified: visited nodes", "nodes", 40u});
    EXPECT_EQ(picture.width, 640u);
    EXPECT_GT(picture.height, 100u);
    EXPECT_EQ(picture.at(0, 0), heatColor(0.25));
    EXPECT_EQ(picture.at(5, 6), heatColor(1));
    EXPECT_EQ(picture.at(7, 8), heatColor(1));
    EXPECT_EQ(picture.at(9, 0), glm::u8vec3(40, 40, 40));
    for (int i = 0; i < 20; ++i) EXPECT_LT(brightness(heatColor(i / 20.0)), brightness(heatColor((i + 1) / 20.0))) << i;
}

TEST(OutputHeatMap, TheLegendShowsTheTrueMaximum) {
    // Two maps that differ in nothing but the true maximum differ in the legend, and only there.
    Raster<uint32_t> a = ramp(400, 50), b = a;
    a.at(0, 0) = 5000;
    b.at(0, 0) = 5001;
    const Picture pa = heatMap(a, {}, {"t", "nodes", 99u}), pb = heatMap(b, {}, {"t", "nodes", 99u});
    ASSERT_EQ(pa.size(), pb.size());
    const auto mapEnd = static_cast<std::ptrdiff_t>(400 * 50);
    EXPECT_TRUE(std::equal(pa.pixels.begin(), pa.pixels.begin() + mapEnd, pb.pixels.begin()));
    EXPECT_FALSE(std::equal(pa.pixels.begin() + mapEnd, pa.pixels.end(), pb.pixels.begin() + mapEnd));

    // The number is really drawn: the text's own pixels are found in the legend.
    Picture text(textWidth("maximum 5000 nodes", 1), textHeight(1));
    drawText(text, 0, 0, "maximum 5000 nodes", 1, {255, 255, 255});
    const auto drawnAt = [&](const Picture& picture, uint32_t x0, uint32_t y0) {
        const glm::u8vec3 ink(160, 160, 165);
        for (uint32_t y = 0; y < text.height; ++y)
            for (uint32_t x = 0; x < text.width; ++x)
                if ((text.at(x, y).x != 0) != (picture.at(x0 + x, y0 + y) == ink)) return false;
        return true;
    };
    const auto drawn = [&](const Picture& picture) {
        for (uint32_t y = 50; y + text.height <= picture.height; ++y)
            for (uint32_t x = 0; x + text.width <= picture.width; ++x)
                if (drawnAt(picture, x, y)) return true;
        return false;
    };
    EXPECT_TRUE(drawn(pa));
    EXPECT_FALSE(drawn(pb));
}

TEST(OutputHeatMap, SmallAndEmptyMapsHaveALegendToo) {
    EXPECT_GE(heatMap(Raster<uint32_t>(1, 1, 7u), {}, {"one pixel", "nodes", {}}).width, 320u);
    EXPECT_GT(heatMap(Raster<uint32_t>(), {}, {}).height, 0u);
    EXPECT_GT(heatMap(Raster<uint32_t>(8, 8, 0xFFFFFFFFu), {}, {"all the same", "", {}}).height, 8u);
}

TEST(OutputPicture, ASingleWrongPixelIsMarked) {
    Raster<uint8_t> want(64, 48, uint8_t{1});
    for (uint32_t y = 10; y < 20; ++y)
        for (uint32_t x = 10; x < 30; ++x) want.at(x, y) = 0;
    want.at(0, 0) = 3;
    Raster<uint8_t> got = want;
    EXPECT_EQ(compareMasks(got, want).wrong, 0u);
    const glm::u8vec3 red(255, 32, 32), yellow(255, 224, 0), magenta(255, 0, 255);
    EXPECT_EQ(countOf(differencePicture(got, want), red) + countOf(differencePicture(got, want), yellow), 0u);
    got.at(12, 15) = 1;
    Picture picture = differencePicture(got, want);
    EXPECT_EQ(countOf(picture, red), 1u);
    EXPECT_EQ(picture.at(12, 15), red);
    got.at(40, 40) = 0;
    got.at(0, 0) = 1;
    picture = differencePicture(got, want);
    EXPECT_EQ(picture.at(40, 40), yellow);
    EXPECT_EQ(picture.at(0, 0), magenta);
    EXPECT_EQ(countOf(picture, yellow), 1u);
    const MaskDifference difference = compareMasks(got, want);
    EXPECT_EQ(difference.wrong, 3u);
    EXPECT_EQ(difference.leaks, 1u);
    EXPECT_EQ(difference.falseDark, 1u);
    EXPECT_THROW((void)differencePicture(got, Raster<uint8_t>(64, 47)), std::invalid_argument);
    for (const glm::u8vec3& pixel : differencePicture(want, want).pixels) EXPECT_LE(std::max({pixel.x, pixel.y, pixel.z}), 96);
}

TEST(OutputPicture, MaskColours) {
    const Raster<uint8_t> visibility(6, 1, std::vector<uint8_t>{0, 1, 2, 3, 4, 5});
    const Picture picture = maskPicture(visibility);
    EXPECT_EQ(picture.at(0, 0), glm::u8vec3(0));
    EXPECT_EQ(picture.at(1, 0), glm::u8vec3(255));
    EXPECT_EQ(picture.at(2, 0).x, picture.at(2, 0).z);
    EXPECT_GT(picture.at(3, 0).z, picture.at(3, 0).x);
    EXPECT_EQ(picture.at(4, 0), kUnknownColor);
    EXPECT_EQ(picture.at(5, 0), glm::u8vec3(255, 0, 255)) << "no visibility";
    for (uint32_t a = 0; a < 6; ++a)
        for (uint32_t b = 0; b < a; ++b) EXPECT_NE(picture.at(a, 0), picture.at(b, 0)) << a << " " << b;
}

// No answer is a wrong one, whatever was wanted, and neither a leak nor false dark; every picture shows it in the same colour.
TEST(OutputPicture, UnknownSamplesAreMarked) {
    const Raster<uint8_t> want(4, 1, std::vector<uint8_t>{0, 1, 2, 3}), got(4, 1, std::vector<uint8_t>{4, 4, 2, 3});
    const MaskDifference difference = compareMasks(got, want);
    EXPECT_EQ(difference.wrong, 2u);
    EXPECT_EQ(difference.leaks + difference.falseDark, 0u);
    EXPECT_EQ(countOf(differencePicture(got, want), kUnknownColor), 2u);
    EXPECT_EQ(countOf(differencePicture(want, want), kUnknownColor), 0u);
    const Raster<glm::vec3> position(4, 1), normal(4, 1, glm::vec3(0, 1, 0)), color(4, 1, glm::vec3(1));
    const Picture shaded = shadePicture({position, normal, color, got, {0, 1, 0, 0}});
    EXPECT_EQ(countOf(shaded, kUnknownColor), 2u);
    EXPECT_EQ(shaded.at(0, 0), kUnknownColor);
}

TEST(OutputPicture, ShadowsAreDarkerAndFullHdIsQuick) {
    const ToyFrame frame(1920, 1080);
    const std::clock_t start = std::clock();
    const Picture picture =
        shadePicture({frame.position, frame.normal, frame.color, frame.visibility, frame.light, glm::vec3(1), {0, 1, 0}, frame.viewer});
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    RecordProperty("milliseconds", static_cast<int>(seconds * 1000));
    EXPECT_LT(seconds, 10.0);  // 0.06 s of processor time, 2 s with sanitizers: the bound only catches a wrong order of growth
    Raster<uint8_t> flipped = frame.visibility;
    for (uint8_t& v : flipped.pixels) v = v == 0 ? 1 : v;
    const Picture lit = shadePicture({frame.position, frame.normal, frame.color, flipped, frame.light, glm::vec3(1), {0, 1, 0}, frame.viewer});
    std::size_t shadowed = 0;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        if (frame.visibility.pixels[i] != 0) {
            ASSERT_EQ(picture.pixels[i], lit.pixels[i]);
            continue;
        }
        ++shadowed;
        ASSERT_LT(brightness(picture.pixels[i]) + 20, brightness(lit.pixels[i]));
    }
    EXPECT_GT(shadowed, 1000u);
    keep("shade.png", picture);
}

TEST(OutputPicture, BesideKeepsEveryPixel) {
    const ToyFrame frame(300, 200);
    Raster<uint8_t> wrong = frame.visibility;
    for (uint32_t i = 0; i < 12; ++i) wrong.at(150 + i, 150) = wrong.at(150 + i, 150) == 1 ? 0 : 1;
    const Picture shaded =
        shadePicture({frame.position, frame.normal, frame.color, frame.visibility, frame.light, glm::vec3(1), {0, 1, 0}, frame.viewer});
    const std::vector<Picture> pictures = {shaded, maskPicture(wrong), differencePicture(wrong, frame.visibility)};
    const std::vector<std::string> captions = {"shaded", "mask", "difference: 12 pixels"};
    const Picture all = beside(pictures, captions);
    EXPECT_GT(all.width, 900u);
    EXPECT_GT(all.height, 200u);
    std::size_t found = 0;
    for (uint32_t y = 0; y < 8 && found == 0; ++y)
        for (uint32_t x = 0; x < 8 && found == 0; ++x) {
            bool same = true;
            for (uint32_t row = 0; row < 200 && same; ++row) same = std::equal(&shaded.at(0, row), &shaded.at(0, row) + 300, &all.at(x, y + row));
            found += same;
        }
    EXPECT_EQ(found, 1u);
    EXPECT_EQ(countOf(all, {255, 32, 32}) + countOf(all, {255, 224, 0}) + countOf(all, {255, 0, 255}), 12u);
    EXPECT_THROW((void)beside(pictures, std::span<const std::string>(captions).first(2)), std::invalid_argument);
    keep("beside.png", all);
}

TEST(OutputPicture, TextIsClippedAtTheEdges) {
    Picture picture(20, 8);
    drawText(picture, -3, -2, "gnomon 0123456789", 2, {255, 255, 255});
    drawText(picture, 15, 5, "W\xC3\xA4", 3, {255, 255, 255});
    EXPECT_GT(countOf(picture, {255, 255, 255}), 0u);
    Picture letters(textWidth("Ag0%", 1), textHeight(1)), wide(textWidth("Ag0%", 3), textHeight(3));
    drawText(letters, 0, 0, "Ag0%", 1, {255, 255, 255});
    drawText(wide, 0, 0, "Ag0%", 3, {255, 255, 255});
    EXPECT_EQ(countOf(wide, {255, 255, 255}), 9 * countOf(letters, {255, 255, 255}));
}

TEST(OutputHeatMap, ToLookAt) {
    const ToyFrame frame(1280, 720);
    Raster<uint32_t> values(1280, 720);
    std::vector<uint8_t> valid(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const glm::vec3 p = frame.position.pixels[i];
        valid[i] = frame.visibility.pixels[i] < 2;
        values.pixels[i] = static_cast<uint32_t>(60 + 50 * std::sin(20 * p.x) * std::cos(14 * p.z)) + (i % 1777 == 0 ? 300u : 0u);
    }
    const Picture picture = heatMap(values, valid, {"d-hybrid, certified: visited nodes per sample", "nodes", {}});
    EXPECT_EQ(picture.width, 1280u);
    EXPECT_EQ(countOf(picture, {40, 40, 40}), static_cast<std::size_t>(std::count(valid.begin(), valid.end(), 0)));
    keep("heat.png", picture);
    keep("heat_small.png", heatMap(ramp(200, 120), {}, {"psv: stack", "entries", 32u}));
}
