// SPDX-License-Identifier: MIT
// Who compares masks must see one wrong pixel, in either direction, wherever it is; and the report of a failed picture must show it.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "host_min/output/shade_picture.hpp"
#include "validation/support/device_test.hpp"
#include "validation/support/image_report.hpp"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace gno {
namespace {

constexpr uint32_t kWidth = 7, kHeight = 5, kCount = kWidth * kHeight;

host::TechniqueResult resultOf(std::vector<uint32_t> mask) {
    host::TechniqueResult result;
    result.visibility = std::move(mask);
    return result;
}

TEST(CompareMasks, AgainstTheOracleOneWrongSample) {
    host::OracleAnswer want;
    for (uint32_t i = 0; i < kCount; ++i) want.inShadow.push_back(i % 3 == 0);
    std::vector<uint32_t> right;
    for (const uint8_t dark : want.inShadow) right.push_back(dark ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT);
    EXPECT_EQ(test::compare(resultOf(right), want).wrong, 0u);
    for (uint32_t i = 0; i < kCount; ++i) {
        std::vector<uint32_t> got = right;
        got[i] = want.inShadow[i] ? GNO_VISIBILITY_LIT : GNO_VISIBILITY_SHADOW;
        const test::Wrong wrong = test::compare(resultOf(got), want);
        EXPECT_EQ(wrong.wrong, 1u);
        EXPECT_EQ(wrong.leaks, want.inShadow[i] ? 1u : 0u);
        EXPECT_EQ(wrong.falseDark, want.inShadow[i] ? 0u : 1u);
        EXPECT_EQ(wrong.first, i);
        for (const uint32_t neither : {GNO_VISIBILITY_FACING_AWAY, GNO_VISIBILITY_BACKGROUND, 0xDEADBEEFu}) {  // what no query may say of a sample
            got[i] = neither;
            EXPECT_EQ(test::compare(resultOf(got), want).wrong, 1u);
        }
    }
    EXPECT_THROW((void)test::compare(resultOf({right.begin(), right.end() - 1}), want), std::logic_error);
    EXPECT_THROW((void)test::compare(resultOf({}), want), std::logic_error);
}

TEST(CompareMasks, OfTheHostOneWrongPixel) {
    host::Raster<uint8_t> want(kWidth, kHeight);
    for (uint32_t i = 0; i < kCount; ++i) want.pixels[i] = uint8_t(i % 4);
    EXPECT_EQ(compareMasks(want, want).wrong, 0u);
    for (uint32_t i = 0; i < kCount; ++i)
        for (uint8_t value = 0; value < 5; ++value) {
            host::Raster<uint8_t> got = want;
            got.pixels[i] = value;
            const host::MaskDifference difference = compareMasks(got, want);
            EXPECT_EQ(difference.wrong, value == want.pixels[i] ? 0u : 1u);
            EXPECT_EQ(difference.leaks, want.pixels[i] == GNO_VISIBILITY_SHADOW && value == GNO_VISIBILITY_LIT ? 1u : 0u);
            EXPECT_EQ(difference.falseDark, want.pixels[i] == GNO_VISIBILITY_LIT && value == GNO_VISIBILITY_SHADOW ? 1u : 0u);
        }
    EXPECT_THROW((void)compareMasks(want, host::Raster<uint8_t>(kHeight, kWidth)), std::invalid_argument);
}

// The comparison on the device: a caster that the oracle knows and the technique does not is one wrong sample, and the other way round.
TEST(CompareMasks, FromTheDevice) {
    test::Scene scene;
    scene.triangles = {{{-0.25f, 0, -0.25f}, {0.25f, 0, -0.25f}, {0, 0, 0.25f}}, {{0.5f, 0, 0.5f}, {0.75f, 0, 0.5f}, {0.5f, 0, 0.75f}}};
    scene.light = {0, 1, 0, 0};
    scene.samples = {{{0, -0.5f, 0}, host::kNoCaster}, {{0.5625f, -0.5f, 0.5625f}, host::kNoCaster}, {{-0.75f, -0.5f, 0}, host::kNoCaster}};
    test::Scene fewer = scene;
    fewer.triangles.pop_back();
    const auto both = test::run(scene, "d-hybrid", host::Precision::certified), one = test::run(fewer, "d-hybrid", host::Precision::certified);
    EXPECT_EQ(test::compare(both, test::ask(scene)).wrong, 0u);
    EXPECT_EQ(test::compare(one, test::ask(fewer)).wrong, 0u);
    const test::Wrong leak = test::compare(one, test::ask(scene)), dark = test::compare(both, test::ask(fewer));
    EXPECT_EQ(leak.wrong, 1u);
    EXPECT_EQ(leak.leaks, 1u);
    EXPECT_EQ(leak.first, 1u);
    EXPECT_EQ(dark.wrong, 1u);
    EXPECT_EQ(dark.falseDark, 1u);
}

struct Loaded {
    int width = 0, height = 0;
    std::vector<glm::u8vec3> pixels;
};

Loaded loadPng(const std::filesystem::path& path) {
    Loaded result;
    int channels = 0;
    stbi_uc* data = stbi_load(path.c_str(), &result.width, &result.height, &channels, 3);
    if (!data) return result;
    for (int i = 0; i < result.width * result.height; ++i) result.pixels.emplace_back(data[3 * i], data[3 * i + 1], data[3 * i + 2]);
    stbi_image_free(data);
    return result;
}

TEST(ImageReport, ShowsOnePlantedPixel) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / ("gnomon_report_" + std::to_string(::getpid()));
    std::vector<uint32_t> want(kCount, GNO_VISIBILITY_LIT), caster(kCount, host::kNoCaster);
    std::vector<host::OracleSample> pixels(kCount, {{0.25f, -0.5f, 0x1p-40f}, 7});
    want[10] = GNO_VISIBILITY_SHADOW;
    caster[10] = 123;
    std::vector<uint32_t> got = want;
    got[10] = GNO_VISIBILITY_LIT;
    const auto place = test::writeReport(folder, {"scene/l0-planted", kWidth, kHeight, got, want, pixels, caster});
    EXPECT_EQ(place, folder / "scene/l0-planted");
    const Loaded gotPicture = loadPng(place / "got.png"), wantPicture = loadPng(place / "want.png"), difference = loadPng(place / "diff.png");
    for (const Loaded* picture : {&gotPicture, &wantPicture, &difference}) {
        ASSERT_EQ(picture->width, int(kWidth));
        ASSERT_EQ(picture->height, int(kHeight));
    }
    for (uint32_t i = 0; i < kCount; ++i) {
        EXPECT_EQ(gotPicture.pixels[i] == wantPicture.pixels[i], i != 10) << i;
        EXPECT_EQ(difference.pixels[i] == glm::u8vec3(255, 32, 32), i == 10) << i;  // red: a leak
    }
    std::stringstream table;
    table << std::ifstream(place / "pixels.csv").rdbuf();
    EXPECT_EQ(table.str(), "x,y,sample_x,sample_y,sample_z,own,caster,got,want\n3,1,0.25,-0.5,9.094947e-13,7,123,1,0\n");
    std::filesystem::remove_all(folder);
}

TEST(ImageReport, SpreadsTheAnswer) {
    host::OracleAnswer answer;
    answer.inShadow = {1, 0};
    answer.caster = {5, host::kNoCaster};
    const std::vector<host::OracleSample> pixels{{{}, GNO_BACKGROUND}, {{}, 3}, {{}, GNO_FACING_AWAY}, {{}, host::kNoCaster}};
    const test::PixelAnswer spreadOut = test::spread(answer, pixels);
    EXPECT_EQ(spreadOut.want,
              (std::vector<uint32_t>{GNO_VISIBILITY_BACKGROUND, GNO_VISIBILITY_SHADOW, GNO_VISIBILITY_FACING_AWAY, GNO_VISIBILITY_LIT}));
    EXPECT_EQ(spreadOut.caster[1], 5u);
    EXPECT_THROW((void)test::spread(answer, std::span(pixels).first(2)), std::logic_error);
    answer.inShadow.pop_back();
    EXPECT_THROW((void)test::spread(answer, pixels), std::logic_error);
}

}  // namespace
}  // namespace gno
