// SPDX-License-Identifier: MIT
// The generated scene `leaves` from file to sums: loader, view samples, buffers and modules on the device, every caster against every sample,
// against the oracle. No acceleration structure is part of it, so what fails here is not a technique's fault.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "host_min/app/effects.hpp"
#include "host_min/frame/inputs.hpp"
#include "host_min/vulkan/recording.hpp"
#include "validation/support/device_test.hpp"
#include "validation/support/spirv_file.hpp"

namespace gno {
namespace {

using host::Binding;

constexpr uint32_t kWidth = 48, kHeight = 36;

host::SceneFile makeLeaves() {
    const auto folder = std::filesystem::temp_directory_path() / fmt::format("gnomon_leaves_{}", ::getpid());
    const std::string command = fmt::format("'{}' make leaves --size 1500 --out '{}' > /dev/null", GNOMON_SCENES_PROGRAM, folder.string());
    if (std::system(command.c_str()) != 0) throw std::runtime_error("gnomon-scenes did not make the scene");
    host::SceneFile file = host::SceneFile::load(folder / "leaves.glb");
    std::filesystem::remove_all(folder);
    return file;
}

struct Push {
    glm::vec4 light;
    uint32_t casters, samples, seed;
};

/// As core/transmittance_sum.glsl keeps them; the stop is where the fourth word's bits say so.
std::vector<glm::uvec3> sumsOnDevice(const host::FrameInputs& inputs, std::span<const host::OracleSample> samples) {
    const host::Device& device = inputs.device();
    host::Buffer in(device, samples.size_bytes()), out(device, samples.size() * 16);
    in.upload(samples);
    out.fill(0);
    static const host::ComputePass pass(device, test::readSpirv(GNOMON_TRANSMITTANCE_SCENE_SPIRV));
    const host::MaterialBuffers& buffers = inputs.materials();
    const std::array resources{Binding{"gnoCasters", &inputs.casters()},
                               Binding{"gnoMaterialOf", &buffers.of()},
                               Binding{"gnoSurfaces", &buffers.surfaces()},
                               Binding{"gnoMaterials", &buffers.list()},
                               Binding{"gnoTexels", &buffers.texels()},
                               Binding{"gnoTransmittances", &out},
                               Binding{"samples", &in}};
    const Push push{inputs.light(), inputs.triangleCount(), static_cast<uint32_t>(samples.size()), 5};
    const uint32_t groups = (push.casters * push.samples + 63) / 64;
    host::Recording recording(device);
    recording.beginPass("sums");
    pass.dispatch(recording, resources, std::as_bytes(std::span(&push, 1)).first(28), 1024, (groups + 1023) / 1024);
    recording.endPass();
    recording.submit();
    std::vector<glm::uvec3> sums;
    for (const glm::uvec4& words : out.downloadAs<glm::uvec4>()) {
        if (sums.size() == samples.size()) break;
        glm::uvec3& sum = sums.emplace_back(words);
        for (int i = 0; i < 3; ++i)
            if ((words.w >> i & 1) != 0) sum[i] = host::kNoLight;
    }
    return sums;
}

TEST(TransmittanceScene, LeavesOnTheDeviceAreTheOracles) {
    const host::SceneFile file = makeLeaves();
    uint64_t lit = 0, dark = 0, grey = 0, coloured = 0, opaqueDark = 0;
    for (const uint32_t number : {0u, 59u}) {
        const host::Frame frame = file.evaluate(number, 0);
        ASSERT_TRUE(frame.look);
        EXPECT_EQ(frame.look->images.size(), 3u);
        host::FrameInputs inputs(test::passes(), frame, kWidth, kHeight);
        for (const host::Light& light : frame.lights) {
            inputs.setLight(light.homogeneous, host::Cull::none);
            std::vector<host::OracleSample> samples;
            for (const host::OracleSample& pixel : inputs.pixels())
                if (pixel.own <= GNO_NO_CASTER) samples.push_back(pixel);
            ASSERT_GT(samples.size(), kWidth * kHeight / 4);
            const host::OracleAnswer want =
                host::makeOracle()->ask({frame.triangles, {}, inputs.light(), samples, frame.surfaceOf, frame.surfaces, frame.look.get()}, {});
            const std::vector<glm::uvec3> got = sumsOnDevice(inputs, samples);
            ASSERT_EQ(got.size(), want.sums.size());
            for (size_t i = 0; i < got.size(); ++i) {
                ASSERT_EQ(got[i], want.sums[i]) << "frame " << number << ", light " << light.name << ", sample " << i;
                EXPECT_TRUE(want.inShadow[i] != 0 || got[i] == glm::uvec3(0)) << "no caster, no contribution";
                lit += got[i] == glm::uvec3(0);
                dark += got[i] == glm::uvec3(host::kNoLight);
                coloured += got[i].x != got[i].y || got[i].y != got[i].z;
                grey += got[i].x == got[i].y && got[i].y == got[i].z && got[i].x != 0 && got[i].x != host::kNoLight;
                opaqueDark += want.inShadow[i];
            }
        }
    }
    fmt::print("lit {}, dark {}, grey {}, coloured {}; {} in shadow if all casters were opaque\n", lit, dark, grey, coloured, opaqueDark);
    EXPECT_GT(lit, 500u);
    EXPECT_GT(dark, 100u);
    EXPECT_GT(coloured, 300u);
    EXPECT_GT(grey, 5u);
    EXPECT_GT(opaqueDark, dark + coloured) << "holes in the leaves";
}

TEST(TransmittanceScene, EffectsNameItsCasters) {
    const host::SceneFile file = makeLeaves();
    const host::Frame frame = file.evaluate(0, 0);
    std::vector<std::string> names;
    for (const host::Effect& effect : host::effectsOf(file, frame, -1)) names.emplace_back(effect.name);
    for (const char* name : {"alpha_tested_casters", "coloured_casters"}) EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
    const host::SceneFile opaque = host::SceneFile::load(GNOMON_SOURCE_DIR "/scenes/show_truck.glb");
    const host::Frame plain = opaque.evaluate(0, 0);
    EXPECT_TRUE(plain.surfaceOf.empty() && plain.surfaces.empty() && !plain.look);
    for (const host::Effect& effect : host::effectsOf(opaque, plain, -1))
        EXPECT_TRUE(effect.name != std::string("alpha_tested_casters") && effect.name != std::string("coloured_casters"));
}

}  // namespace
}  // namespace gno
