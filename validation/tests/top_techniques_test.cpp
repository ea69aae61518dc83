// SPDX-License-Identifier: MIT
// The four techniques on one TOP tree, through the library: whatever the query, the stack and the shader stage, the masks are the same; on the
// certified rung they are the oracle's.
#include <gtest/gtest.h>

#include "validation/tests/made_scenes.hpp"

namespace gno {
namespace {

using host::Precision;
using host::cases::HardCase;
using Strings = std::vector<std::string>;

const Strings kTop{"psv", "d-psv", "d-stackless", "d-hybrid"};
constexpr uint32_t kSeed = 1907;

test::Scene sceneOf(const HardCase& hard) { return {hard.triangles, {}, hard.light, hard.samples, host::Cull::none}; }

/// Without counters, so that only the timed shaders run.
std::vector<std::vector<uint32_t>> masks(const test::Scene& scene, const Strings& names, Precision precision, const std::vector<Strings>& settings) {
    host::Frame frame;
    frame.triangles = scene.triangles;
    frame.closed.assign(scene.triangles.size(), 0);
    host::FrameInputs inputs(test::passes(), frame, scene.samples);
    inputs.setLight(scene.light, scene.cull);
    host::StructureCache structures;
    std::vector<std::vector<uint32_t>> result;
    for (const Strings& given : settings)
        for (const std::string& name : names) {
            host::Technique& technique = host::techniqueByName(name);
            result.push_back(technique
                                 .run(inputs, structures, host::Settings(technique.info().settings, given),
                                      {.precision = precision, .counters = false, .warmUp = false})
                                 .visibility);
            result.back().resize(scene.samples.size());
        }
    return result;
}

void expectOneMask(const test::Scene& scene, const Strings& names, const std::vector<Strings>& settings, bool fp32DecidesAlike) {
    const host::OracleAnswer want = test::ask(scene);
    for (const auto precision : {Precision::conservative, Precision::certified}) {
        const auto got = masks(scene, names, precision, settings);
        for (size_t i = 0; i < got.size(); ++i) {
            host::TechniqueResult result;
            result.visibility = got[i];
            const test::Wrong wrong = test::compare(result, want);
            if (precision == Precision::certified || fp32DecidesAlike) {
                EXPECT_EQ(wrong.wrong, 0u) << name(precision) << ", " << names[i % names.size()] << " with "
                                           << testing::PrintToString(settings[i / names.size()]) << ", first wrong: sample " << wrong.first
                                           << ", leaks " << wrong.leaks;
            }
        }
    }
}

TEST(TopTechniques, OneMaskWhateverTheStack) {
    for (const bool directional : {false, true}) {
        const test::Scene scene = test::soup(kSeed, directional, 400, 0.4, 3000);
        EXPECT_GT(test::run(scene, "d-psv", Precision::certified).counters.maxStack, 2u);  // the small stacks below do overflow
        expectOneMask(scene, {"psv", "d-psv", "d-hybrid"}, {{"stack=1"}, {"stack=2"}, {"stack=7"}, {"stack=48"}}, true);
        expectOneMask(scene, kTop, {{}}, true);
    }
}

TEST(TopTechniques, FragmentStage) {
    for (const bool directional : {false, true}) {
        // lavapipe 25.0 with LLVM 15 crashes when it compiles a graphics pipeline for width 16: there the compute stage stands alone.
        std::vector<std::vector<std::string>> stages{{"stage=compute"}};
        if (test::passes().device().facts().subgroupSize <= 8) stages.push_back({"stage=fragment"});
        expectOneMask(test::soup(kSeed, directional, 1500, 0.15, 3000), kTop, stages, true);
    }
}

TEST(TopTechniques, InsertionOrderAndWorkGroup) {
    expectOneMask(test::soup(kSeed, false, 1500, 0.15, 3000), {"d-hybrid"},
                  {{"seed=0"}, {"seed=4294967295"}, {"group=1"}, {"group=100"}, {"group=256", "seed=9"}}, true);
}

// Samples on and next to planes, edges, vertices: only the definition knows, and the certified rung.
TEST(TopTechniques, HardCases) {
    for (const HardCase& hard : host::cases::hardCases(kSeed, 320)) {
        if (!hard.isCaster.empty()) continue;
        SCOPED_TRACE(hard.name);
        test::Scene scene = sceneOf(hard);
        test::keepTheContract(scene);
        const host::OracleAnswer want = test::ask(scene);
        const std::vector<Strings> settings{{}};
        const auto got = masks(scene, kTop, Precision::certified, settings);
        for (size_t i = 0; i < got.size(); ++i) {
            host::TechniqueResult result;
            result.visibility = got[i];
            const test::Wrong wrong = test::compare(result, want);
            EXPECT_EQ(wrong.wrong, 0u) << kTop[i] << ", leaks " << wrong.leaks << ", first wrong: sample " << wrong.first << " of own "
                                       << scene.samples[wrong.first].own << ", oracle's caster " << want.caster[wrong.first];
        }
    }
}

}  // namespace
}  // namespace gno
