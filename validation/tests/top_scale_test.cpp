// SPDX-License-Identifier: MIT
// More than a million casters in one tree, against the oracle; and what does not fit the device is refused in one line, never cut off.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>

#include "host_min/error.hpp"
#include "validation/support/device_test.hpp"
#include "validation/support/image_report.hpp"
#include "validation/tests/top_structure.hpp"

namespace gno {
namespace {

using host::Precision;

constexpr uint32_t kSize = 96;

struct BigScene {
    host::Frame frame;
    BigScene() {
        const auto folder = std::filesystem::temp_directory_path() / fmt::format("gnomon_scale_{}", ::getpid());
        const std::string command = fmt::format("'{}' make bricks --size 1150000 --out '{}' > /dev/null", GNOMON_SCENES_PROGRAM, folder.string());
        if (std::system(command.c_str()) != 0) throw std::runtime_error("gnomon-scenes did not make the scene");
        frame = host::SceneFile::load(folder / "bricks.glb").evaluate(0, 0);
        std::filesystem::remove_all(folder);
    }
};

class Clock {
public:
    void lap(const char* what) {
        const auto now = std::chrono::steady_clock::now();
        std::printf("%-12s %.1f s\n", what, std::chrono::duration<double>(now - last_).count());
        std::fflush(stdout);
        last_ = now;
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

TEST(TopScale, AMillionCasters) {
    Clock clock;
    const BigScene scene;
    clock.lap("scene");
    const size_t count = scene.frame.triangles.size();
    ASSERT_GT(count, 1100000u);
    host::FrameInputs inputs(test::passes(), scene.frame, kSize, kSize);
    inputs.setLight(scene.frame.lights.at(0).homogeneous, host::Cull::none);
    ASSERT_GT(inputs.casterCount(), 1100000u);
    ASSERT_GT(inputs.sampleCount(), uint64_t(kSize) * kSize / 8);
    clock.lap("inputs");

    std::vector<host::OracleSample> samples;
    for (const host::OracleSample& pixel : inputs.pixels())
        if (pixel.own <= GNO_NO_CASTER) samples.push_back(pixel);
    const host::OracleAnswer answer = host::makeOracle()->ask({scene.frame.triangles, {}, inputs.light(), samples}, [](double) {});
    EXPECT_EQ(answer.selfShadowed, 0u);
    const test::PixelAnswer want = test::spread(answer, inputs.pixels());
    clock.lap("oracle");

    host::StructureCache structures;
    host::TechniqueResult result;
    for (const char* technique : {"d-hybrid", "psv", "d-stackless"}) {  // on one tree
        host::Technique& query = host::techniqueByName(technique);
        result = query.run(inputs, structures, host::Settings(query.info().settings, {}),
                           {Precision::certified, 1, false, std::string(technique) == "d-stackless"});
        EXPECT_EQ(result.visibility, want.want) << technique;
        clock.lap(technique);
    }

    test::TopBuffers tree;
    for (const host::DumpedBuffer& buffer : result.dump) {
        const auto fill = [&](auto& list) {
            list.resize(buffer.bytes.size() / sizeof(list[0])), std::memcpy(list.data(), buffer.bytes.data(), buffer.bytes.size());
        };
        if (buffer.name == "planes") fill(tree.planes);
        if (buffer.name == "links") fill(tree.links);
        if (buffer.name == "header") std::memcpy(&tree.header, buffer.bytes.data(), sizeof tree.header);
    }
    std::vector<uint8_t> kept;
    for (const host::Triangle& t : scene.frame.triangles)
        kept.push_back(exact::orient3dLight(inputs.light(), exact::fixed(t.a), exact::fixed(t.b), exact::fixed(t.c)) != 0);
    const test::TopWalk walked = walk(tree, kept);
    EXPECT_EQ(walked.error, "");
    std::printf("%zu casters, %zu in the tree\n", count, walked.order.size());
    EXPECT_GT(walked.order.size(), 10000u);
    clock.lap("walk");

    // The number of work groups of one dispatch has a limit too: small groups pass it long before the buffers do.
    host::StructureCache none;
    host::Technique& query = host::techniqueByName("psv");
    const std::vector<std::string> small{"group=1"};
    try {
        (void)query.run(inputs, none, host::Settings(query.info().settings, small), {.precision = Precision::certified, .counters = false});
        ADD_FAILURE() << "more than 65535 work groups were taken";
    } catch (const host::InputError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("group"), std::string::npos) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    }
}

TEST(TopScale, MoreThanTheDeviceHoldsIsRefused) {
    const uint64_t limit = test::passes().device().facts().maxStorageBufferRange / 64;
    host::Frame frame;
    frame.triangles.assign(size_t(limit + 1), {{0, 0, 0.5f}, {0.25f, 0, 0.5f}, {0, 0.25f, 0.5f}});
    frame.closed.assign(frame.triangles.size(), 0);
    const std::array samples{host::OracleSample{{0, 0, 0}, host::kNoCaster}};
    try {
        const host::FrameInputs inputs(test::passes(), frame, samples);
        ADD_FAILURE() << "a caster too many was taken";
    } catch (const host::InputError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find(std::to_string(limit + 1)), std::string::npos) << text;
        EXPECT_NE(text.find(std::to_string(limit)), std::string::npos) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    }
}

TEST(TopScale, ABufferOverTheLimitIsRefused) {
    const uint64_t limit = test::passes().device().facts().maxStorageBufferRange;
    EXPECT_THROW(host::Buffer(test::passes().device(), limit + 16), host::InputError);
}

}  // namespace
}  // namespace gno
