// SPDX-License-Identifier: MIT
// Shadow volumes against the hierarchy, for all combinations of bounds, split, planes, job list and work groups: the mask is the oracle's, on the
// certified rung and, where no sign is near zero, on the conservative one.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "host_min/techniques/cluster_hierarchy.hpp"
#include "host_min/techniques/query_pass.hpp"
#include "validation/support/camera_view.hpp"
#include "validation/support/device_test.hpp"
#include "validation/tests/oracle_cases.hpp"

namespace gno {
namespace {

using host::Precision;
using test::CameraView;
constexpr uint32_t kSeed = 414, kMany = 1u << 16, kCertified = GNO_PRECISION_CERTIFIED;

/// A floor, casters of all sizes above it, and one big caster before a part of them.
CameraView soup(bool directional, bool perspective) {
    host::cases::Random random(kSeed);
    CameraView view;
    view.width = 61;
    view.height = 43;
    view.light = directional ? glm::vec4(0.375f, 1, 0.25f, 0) : glm::vec4(0.25f, 0.96875f, 0.375f, 1);
    view.frame.camera = test::lookAt({0.3, 0.6, 0.9}, {0, -0.5, -0.1}, perspective ? 0.5 : 0.6, perspective);
    auto& triangles = view.frame.triangles;
    host::cases::addQuad(triangles, {-1, -0.75f, -1}, {-1, -0.75f, 1}, {1, -0.75f, 1}, {1, -0.75f, -1});
    triangles.push_back({{-0.625f, 0.25f, -0.5f}, {-0.25f, 0.28125f, 0.5f}, {0.25f, 0.25f, -0.625f}});
    while (triangles.size() < 48) {
        const glm::dvec3 at = random.inCube(0.7) + glm::dvec3(0, -0.2, 0);
        const double size = std::ldexp(0.4, -int(random.below(4)));
        const auto corner = [&] { return host::cases::snap(at * 0.9 + random.inCube(size) * 0.5); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        triangles.push_back({a, b, c});
    }
    fillPixels(view);
    return view;
}

host::FrameInputs inputsOf(const CameraView& view) {
    host::FrameInputs inputs(test::passes(), view.frame, view.pixels, view.width);
    inputs.setLight(view.light, host::Cull::none);
    return inputs;
}

class Runner {
public:
    explicit Runner(const CameraView& view) : inputs_(inputsOf(view)) {}

    std::vector<uint32_t> run(const ClusterOptions& options) {
        return ask(host::built<host::ClusterHierarchy>(inputs_, options, {.warmUp = false, .counters = false}));
    }

    host::ClusterCounters count(const ClusterOptions& options, std::vector<uint32_t>& mask) {
        const auto hierarchy = host::built<host::ClusterHierarchy>(inputs_, options);
        mask = ask(hierarchy);
        return hierarchy.counters();
    }

private:
    std::vector<uint32_t> ask(const host::ClusterHierarchy& hierarchy) const {
        host::TechniqueResult result;
        host::ask(inputs_, {clusterQueryPasses(inputs_.width(), inputs_.height(), hierarchy.options()), hierarchy.bindings(), false},
                  {.counters = false, .warmUp = false}, result);
        return result.visibility;
    }
    host::FrameInputs inputs_;
};

std::string describe(const ClusterOptions& o) {
    return fmt::format("{}, form {}, split {}, {} planes, {} jobs, {} groups, {} boxes", name(Precision(o.precision)), uint32_t(o.form), o.split,
                       o.extraPlanes ? 7 : 4, o.jobCapacity, o.groups, o.boxCapacity);
}

/// Empty: the same; else how many differ and where first.
std::string difference(const std::vector<uint32_t>& got, const std::vector<uint32_t>& want) {
    uint64_t wrong = 0;
    size_t first = got.size();
    for (size_t i = got.size(); i-- > 0;)
        if (got[i] != want[i]) ++wrong, first = i;
    return wrong == 0 ? "" : fmt::format("{} of {} wrong, first pixel {}: {} for {}", wrong, got.size(), first, got[first], want[first]);
}

/// A traversal takes about a second to compile for 8 lanes and three for 16, so each width leaves out what differs least from the rest.
bool takesPart(const ClusterOptions& options) {
    const uint32_t width = test::passes().device().facts().subgroupSize;
    if (options.precision == GNO_PRECISION_CONSERVATIVE) return width == 8 && options.form == ClusterForm::compact;
    return width < 16 || options.form == ClusterForm::compact || options.form == ClusterForm::flat;
}

void expectProduct(const CameraView& view) {
    const std::vector<uint32_t> want = oracleMask(view);
    for (const uint32_t kind : {GNO_VISIBILITY_LIT, GNO_VISIBILITY_SHADOW}) ASSERT_GT(std::count(want.begin(), want.end(), kind), 150) << kind;
    Runner runner(view);
    uint32_t runs = 0;
    for (const auto precision : {Precision::certified, Precision::conservative})
        for (const ClusterForm form : {ClusterForm::implicitBounds, ClusterForm::explicitBounds, ClusterForm::compact, ClusterForm::flat})
            for (const uint32_t split : {0u, 1u, 2u, 6u})  // 6: the last level there is
                for (const uint32_t jobs : {kMany, 1u, 0u})
                    for (const bool extra : {true, false})
                        for (const uint32_t groups : {64u, 1u, 3u}) {
                            const ClusterOptions options{uint32_t(precision), form, split, extra, groups, jobs, kMany};
                            if ((split == 0 && jobs != kMany) || !takesPart(options)) continue;  // without a split there is no list
                            ++runs;
                            ASSERT_EQ(difference(runner.run(options), want), "") << describe(options);
                        }
    std::printf("%u combinations\n", runs);
}

TEST(ClusterTraverse, PointLight) { expectProduct(soup(false, true)); }
TEST(ClusterTraverse, DirectionalLight) { expectProduct(soup(true, true)); }

TEST(ClusterTraverse, OrthographicAndFewBoxes) {
    for (const bool directional : {false, true}) {
        const CameraView view = soup(directional, false);
        const std::vector<uint32_t> want = oracleMask(view);
        Runner runner(view);
        for (const uint32_t boxes : {kMany, 1u, 60u})
            for (const ClusterForm form : {ClusterForm::implicitBounds, ClusterForm::compact, ClusterForm::flat}) {
                const ClusterOptions options{kCertified, form, 2, true, 64, kMany, boxes};
                EXPECT_EQ(difference(runner.run(options), want), "") << describe(options);
            }
    }
}

// Nothing depends on who comes first.
TEST(ClusterTraverse, TwentyRepeats) {
    const CameraView view = soup(false, true);
    const std::vector<uint32_t> want = oracleMask(view);
    Runner runner(view);
    for (int i = 0; i < 20; ++i) {
        const ClusterOptions options{kCertified, ClusterForm::compact, uint32_t(i % 3), true, 64, i % 2 ? kMany : 40u, kMany};
        ASSERT_EQ(difference(runner.run(options), want), "") << "repeat " << i << ", " << describe(options);
    }
}

/// A lid over everything that the camera sees, and small casters under it.
CameraView lid() {
    CameraView view = soup(false, true);
    view.width = 128;
    view.height = 128;
    view.frame.triangles.resize(9);
    view.frame.triangles.push_back({{-1, 0.9375f, -1}, {1, 0.9375f, -1}, {0, 0.9375f, 1}});
    fillPixels(view);
    return view;
}

TEST(ClusterTraverse, AcceptedNodesAndCounters) {
    const CameraView view = lid();
    const std::vector<uint32_t> want = oracleMask(view);
    const uint64_t dark = uint64_t(std::count(want.begin(), want.end(), GNO_VISIBILITY_SHADOW));
    ASSERT_GT(dark, 2000u);
    Runner runner(view);
    for (const uint32_t split : {0u, 2u}) {
        std::vector<uint32_t> mask;
        const ClusterOptions options{kCertified, ClusterForm::compact, split, true, 64, kMany, kMany};
        const host::ClusterCounters c = runner.count(options, mask);
        EXPECT_EQ(difference(mask, want), "") << describe(options);
        EXPECT_GT(c.accepted, 0u);
        EXPECT_LT(c.leafTests, dark) << "most of the dark samples must come from accepted nodes, found by the merge pass";
        EXPECT_EQ(std::accumulate(c.testsOfPixel.begin(), c.testsOfPixel.end(), uint64_t(0)), c.leafTests);
        EXPECT_GE(c.planeTests, c.nodeTests) << "each tested node looks at a plane";
        EXPECT_LE(c.planeTests, 7 * c.nodeTests);
        EXPECT_EQ(c.expandSteps.size(), view.frame.triangles.size());
        EXPECT_TRUE(std::all_of(c.expandSteps.begin(), c.expandSteps.end(), [](uint32_t s) { return s > 0; })) << "every caster is a job";
        EXPECT_EQ(c.finishSteps.size(), c.jobs);
        EXPECT_EQ(c.jobs > 0, split > 0);
        EXPECT_GT(c.occupiedNodes, 50u);
        EXPECT_EQ(c.boxes, c.occupiedNodes);
    }
    host::Technique& technique = host::techniqueByName("ptsv");
    const host::FrameInputs inputs = inputsOf(view);
    host::StructureCache structures;
    const host::TechniqueResult result =
        technique.run(inputs, structures, host::Settings(technique.info().settings, {}), {.precision = Precision::certified, .warmUp = false});
    const auto number = [&](const std::string& key) {
        for (const auto& [name, value] : result.counters.more)
            if (name == key) return value;
        ADD_FAILURE() << "no counter " << key;
        return uint64_t(0);
    };
    EXPECT_EQ(result.counters.testAndSet, number("node_tests") + number("leaf_tests"));
    EXPECT_GT(number("accepted_nodes"), 0u);
    EXPECT_EQ(difference(result.visibility, want), "");
}

TEST(ClusterTraverse, ShippedScene) {
    const host::SceneFile file = host::SceneFile::load("scenes/fence/fence.glb");  // tests run in the project's folder
    CameraView view;
    view.frame = file.evaluate(0, 0);
    view.width = view.height = 128;
    ASSERT_GE(view.frame.lights.size(), 2u);
    for (size_t light = 0; light < 2; ++light) {
        view.light = view.frame.lights[light].homogeneous;
        fillPixels(view);
        const std::vector<uint32_t> want = oracleMask(view);
        Runner runner(view);
        for (const ClusterForm form : {ClusterForm::implicitBounds, ClusterForm::explicitBounds, ClusterForm::compact, ClusterForm::flat})
            for (const uint32_t split : {0u, 2u}) {
                const ClusterOptions options{kCertified, form, split, true, 64, kMany, kMany};
                if (!takesPart(options)) continue;
                EXPECT_EQ(difference(runner.run(options), want), "") << "light " << light << ", " << describe(options);
            }
    }
}

}  // namespace
}  // namespace gno
