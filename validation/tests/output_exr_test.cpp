// SPDX-License-Identifier: MIT
// What is written as EXR or PNG comes back to the bit. PNGs are read by stb_image, which shares no code with the writer.
#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string>

#include "host_min/error.hpp"
#include "host_min/output/exr.hpp"
#include "host_min/output/png.hpp"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

using namespace gno::host;
namespace fs = std::filesystem;

namespace {

constexpr uint32_t kWidth = 37, kHeight = 23;  // no multiple of a tile, a block of 16 lines, or 4

class OutputExr : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() / ("gnomon_output_exr_" + std::string(test->name()) + "_" + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path folder_;
};

std::vector<uint32_t> words(uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<uint32_t> values(kWidth * kHeight);
    for (uint32_t& value : values) value = static_cast<uint32_t>(random());
    values.front() = 0xFFFFFFFDu;
    values.back() = 0xFFFFFFFFu;
    return values;
}

std::vector<ExrLayer> layers() {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> coordinate(-1, 1);
    std::vector<glm::vec3> position(kWidth * kHeight);
    for (glm::vec3& p : position) p = {coordinate(random), coordinate(random), coordinate(random)};
    position[0] = {-0.0f, std::ldexp(1.0f, -40), std::numeric_limits<float>::denorm_min()};
    std::vector<uint8_t> visibility(kWidth * kHeight);
    for (std::size_t i = 0; i < visibility.size(); ++i) visibility[i] = static_cast<uint8_t>(i < 256 ? i : i % 4);
    return {exrVectorLayer("position", position),
            {"primitive", {{"", words(1)}}},
            {"d-psv.conservative", {{"visibility", visibility}, {"visited_nodes", words(2)}, {"stack", words(3)}}}};
}

}  // namespace

TEST_F(OutputExr, EveryChannelComesBackByNameAndBits) {
    const fs::path path = folder_ / "frame.exr";
    const std::vector<ExrLayer> want = layers();
    writeExr(path, kWidth, kHeight, want);
    const ExrFile got = readExr(path);
    EXPECT_EQ(got.width, kWidth);
    EXPECT_EQ(got.height, kHeight);
    ASSERT_EQ(got.channels.size(), 7u);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& floats = std::get<std::vector<float>>(got.channels.at("position." + want[0].channels[axis].name));
        const auto& expected = std::get<std::vector<float>>(want[0].channels[axis].pixels);
        ASSERT_EQ(floats.size(), expected.size());
        for (std::size_t i = 0; i < floats.size(); ++i) ASSERT_EQ(std::bit_cast<uint32_t>(floats[i]), std::bit_cast<uint32_t>(expected[i]));
    }
    EXPECT_EQ(want[0].channels[2].name, "Z");
    EXPECT_EQ(std::get<std::vector<uint32_t>>(got.channels.at("primitive")), words(1));
    EXPECT_EQ(std::get<std::vector<uint32_t>>(got.channels.at("primitive")).front(), 0xFFFFFFFDu);
    EXPECT_EQ(std::get<std::vector<uint32_t>>(got.channels.at("d-psv.conservative.visited_nodes")), words(2));
    EXPECT_EQ(std::get<std::vector<uint32_t>>(got.channels.at("d-psv.conservative.stack")), words(3));
    const auto& visibility = std::get<std::vector<float>>(got.channels.at("d-psv.conservative.visibility"));
    const auto& expected = std::get<std::vector<uint8_t>>(want[2].channels[0].pixels);
    for (std::size_t i = 0; i < visibility.size(); ++i) ASSERT_EQ(visibility[i], static_cast<float>(expected[i]));
}

TEST_F(OutputExr, WrongCallsAndBrokenFilesAreToldApart) {
    const fs::path path = folder_ / "frame.exr";
    std::vector<ExrLayer> bad = layers();
    std::get<std::vector<uint32_t>>(bad[1].channels[0].pixels).pop_back();
    EXPECT_THROW(writeExr(path, kWidth, kHeight, bad), std::invalid_argument);
    bad = layers();
    bad.push_back(bad[1]);
    EXPECT_THROW(writeExr(path, kWidth, kHeight, bad), std::invalid_argument);
    EXPECT_TRUE(fs::is_empty(folder_));
    EXPECT_THROW((void)readExr(path), InputError);
    writeExr(path, kWidth, kHeight, layers());
    fs::resize_file(path, fs::file_size(path) / 2);
    EXPECT_THROW((void)readExr(path), InputError);
    std::ofstream(path) << "no picture at all";
    EXPECT_THROW((void)readExr(path), InputError);
    EXPECT_THROW(writeExr(folder_ / "missing" / "frame.exr", kWidth, kHeight, layers()), InputError);
    EXPECT_THROW(writeExr("/dev/full", kWidth, kHeight, layers()), RoomError);
}

TEST_F(OutputExr, PngDecodesToTheSamePixels) {
    std::mt19937 random(3);
    Picture picture(kWidth, kHeight);
    Raster<uint8_t> gray(kWidth, kHeight);
    for (glm::u8vec3& pixel : picture.pixels) pixel = {random() & 255u, random() & 255u, random() & 255u};
    for (uint8_t& pixel : gray.pixels) pixel = static_cast<uint8_t>(random());
    writePng(folder_ / "color.png", picture);
    writeGrayPng(folder_ / "gray.png", gray);

    int width = 0, height = 0, channels = 0;
    stbi_uc* bytes = stbi_load((folder_ / "color.png").c_str(), &width, &height, &channels, 0);
    ASSERT_NE(bytes, nullptr);
    ASSERT_EQ(channels, 3);
    ASSERT_EQ(width, static_cast<int>(kWidth));
    ASSERT_EQ(height, static_cast<int>(kHeight));
    for (std::size_t i = 0; i < picture.size(); ++i)
        for (int c = 0; c < 3; ++c) ASSERT_EQ(bytes[i * 3 + static_cast<std::size_t>(c)], picture.pixels[i][c]);
    stbi_image_free(bytes);

    bytes = stbi_load((folder_ / "gray.png").c_str(), &width, &height, &channels, 0);
    ASSERT_NE(bytes, nullptr);
    ASSERT_EQ(channels, 1);
    for (std::size_t i = 0; i < gray.size(); ++i) ASSERT_EQ(bytes[i], gray.pixels[i]);
    stbi_image_free(bytes);
    EXPECT_THROW(writePng("/dev/full", Picture(400, 400)), RoomError);
}
