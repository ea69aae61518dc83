// SPDX-License-Identifier: MIT
// The shipped scenes, lights 0 and 1, every query of a TOP tree on every rung against the oracle. A failure leaves pictures and a table behind.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "validation/support/device_test.hpp"
#include "validation/support/image_report.hpp"

namespace gno {
namespace {

using host::Precision;
namespace fs = std::filesystem;

const std::vector<std::string> kTop{"psv", "d-psv", "d-stackless", "d-hybrid"};

/// All that ship, at the width that most machines have; two at the others, the queries being the same code.
std::vector<fs::path> scenes() {
    const fs::path folder = "scenes";  // tests run in the project's folder
    if (test::passes().device().facts().subgroupSize != 8) return {folder / "show_stairs.glb", folder / "fence" / "fence.glb"};
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".glb") found.push_back(entry.path());
        if (!entry.is_directory() || entry.path().filename() == "generated") continue;
        for (const auto& file : fs::directory_iterator(entry.path()))
            if (file.path().extension() == ".glb") found.push_back(file.path());
    }
    std::sort(found.begin(), found.end());
    return found;
}

host::OracleAnswer askAbout(const host::FrameInputs& inputs) {
    std::vector<host::OracleSample> samples;
    for (const host::OracleSample& pixel : inputs.pixels())
        if (pixel.own <= GNO_NO_CASTER) samples.push_back(pixel);
    return host::makeOracle()->ask({inputs.frame().triangles, {}, inputs.light(), samples}, [](double) {});
}

uint64_t countWrong(const std::vector<uint32_t>& got, const std::vector<uint32_t>& want) {
    uint64_t wrong = 0;
    for (size_t i = 0; i < want.size(); ++i) wrong += got[i] != want[i];
    return wrong;
}

struct Tally {
    uint64_t samples = 0, wrong = 0;  ///< of the conservative rung
};

void expectExact(const host::FrameInputs& inputs, const std::string& what, Tally& tally) {
    const host::OracleAnswer answer = askAbout(inputs);
    EXPECT_EQ(answer.selfShadowed, 0u) << what << ": samples that only their own triangle darkens";
    const test::PixelAnswer expected = test::spread(answer, inputs.pixels());
    host::StructureCache structures;
    for (const auto precision : {Precision::published, Precision::conservative, Precision::certified}) {
        std::vector<uint32_t> first;
        for (const std::string& technique : kTop) {
            host::Technique& query = host::techniqueByName(technique);
            const auto got =
                query
                    .run(inputs, structures, host::Settings(query.info().settings, {}), {.precision = precision, .counters = false, .warmUp = false})
                    .visibility;
            ASSERT_EQ(got.size(), expected.want.size());
            const uint64_t wrong = countWrong(got, expected.want);
            const std::string where = fmt::format("{}-{}.{}", what, technique, name(precision));
            bool bad = precision == Precision::certified && wrong > 0;
            if (precision == Precision::conservative && technique == kTop.front()) {
                tally.samples += inputs.sampleCount();
                tally.wrong += wrong;
            }
            if (precision != Precision::published) {  // a query of the published tree may lose what its stack cannot hold
                if (first.empty()) first = got;
                bad = bad || got != first;
                EXPECT_EQ(countWrong(got, first), 0u) << where << " differs from " << kTop.front();
            }
            if (bad) {
                const test::MaskReport report{where, inputs.width(), inputs.height(), got, expected.want, inputs.pixels(), expected.caster};
                ADD_FAILURE() << where << ": " << wrong << " of " << inputs.sampleCount() << " wrong, see "
                              << writeReport(GNOMON_FAILURES_DIR, report).string();
            }
            if (precision == Precision::published || wrong > 0)
                std::printf("%s: %llu of %llu wrong\n", where.c_str(), (unsigned long long)wrong, (unsigned long long)inputs.sampleCount());
        }
    }
}

TEST(TopImages, ShippedScenes) {
    const auto all = scenes();
    ASSERT_GE(all.size(), 2u);
    Tally tally;
    for (const fs::path& path : all) {
        const host::SceneFile file = host::SceneFile::load(path);
        const host::Frame frame = file.evaluate(0, 0);
        const uint32_t size = 128;
        host::FrameInputs inputs(test::passes(), frame, size, size);
        ASSERT_GE(frame.lights.size(), 2u) << path;
        for (size_t light = 0; light < 2; ++light) {
            inputs.setLight(frame.lights[light].homogeneous, host::Cull::none);
            EXPECT_GT(inputs.sampleCount(), 0u) << path << " light " << light;
            expectExact(inputs, fmt::format("{}-l{}", path.stem().string(), light), tally);
        }
    }
    std::printf("conservative: %llu of %llu wrong\n", (unsigned long long)tally.wrong, (unsigned long long)tally.samples);
    EXPECT_LT(10000 * tally.wrong, tally.samples);
}

}  // namespace
}  // namespace gno
