// SPDX-License-Identifier: MIT
// The traversal counts the invocations that are active: it is right where a driver runs fewer of them than gl_SubgroupSize says, and where some of a
// subgroup are missing. Both are emulated: by main() that sends a part of each subgroup home, and by SPIR-V whose loads of gl_SubgroupSize give 32.
// The text that took the size, the id or the ballot as it is has to fail.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_min/techniques/cluster_hierarchy.hpp"
#include "validation/support/camera_view.hpp"
#include "validation/support/device_test.hpp"
#include "validation/support/shader_compile.hpp"
#include "validation/tests/oracle_cases.hpp"

namespace gno {
namespace {

using test::CameraView;
constexpr const char* kTraverse = "clusters/examples/traverse.comp";
constexpr const char* kAll = "true";

/// A floor and casters of all sizes above it.
CameraView scene() {
    host::cases::Random random(415);
    CameraView view;
    view.width = 72;
    view.height = 56;
    view.light = {0.25f, 0.96875f, 0.375f, 1};
    view.frame.camera = test::lookAt({0.3, 0.6, 0.9}, {0, -0.5, -0.1}, 0.5);
    auto& triangles = view.frame.triangles;
    host::cases::addQuad(triangles, {-1, -0.75f, -1}, {-1, -0.75f, 1}, {1, -0.75f, 1}, {1, -0.75f, -1});
    triangles.push_back({{-0.625f, 0.25f, -0.5f}, {-0.25f, 0.28125f, 0.5f}, {0.25f, 0.25f, -0.625f}});
    while (triangles.size() < 40) {
        const glm::dvec3 at = random.inCube(0.7) + glm::dvec3(0, -0.2, 0);
        const double size = std::ldexp(0.4, -int(random.below(4)));
        const auto corner = [&] { return host::cases::snap(at * 0.9 + random.inCube(size) * 0.5); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        triangles.push_back({a, b, c});
    }
    fillPixels(view);
    return view;
}

/// Compiles the example with `from` of clusters/traverse.glsl replaced (empty: nothing), for the invocations that fulfil `active`.
std::vector<uint32_t> traversal(const std::string& active, const std::string& from = "", const std::string& to = "") {
    const std::filesystem::path glsl = GNOMON_SOURCE_DIR "/glsl";
    const test::Mount mount(glsl, "gnomon", true);
    std::string text = test::readText(glsl / "clusters/traverse.glsl");
    if (!from.empty()) {
        const size_t at = text.find(from);
        if (at == std::string::npos || text.find(from, at + 1) != std::string::npos) throw std::runtime_error("not once in traverse.glsl: " + from);
        text.replace(at, from.size(), to);
    }
    (void)mount.put("gnomon/clusters/traverse.glsl", text);
    const auto compiled = mount.compile(mount.put("traverse.comp",
                                                  "#version 450\n"
                                                  "#extension GL_GOOGLE_include_directive : require\n"
                                                  "#extension GL_KHR_shader_subgroup_basic : require\n"
                                                  "#extension GL_KHR_shader_subgroup_ballot : require\n"
                                                  "#define GNO_CLUSTER_LAYERS 0\n"
                                                  "#define main traverse\n"
                                                  "#include \"gnomon/clusters/examples/traverse_comp.glsl\"\n"
                                                  "#undef main\n"
                                                  "void main() { if (" +
                                                      active + ") traverse(); }\n"),
                                        "vulkan1.2", false);
    if (!compiled.good) throw std::runtime_error(compiled.output);
    return compiled.spirv;
}

/// Every load of gl_SubgroupSize gives 32 instead. How many there were.
uint32_t saySizeIs32(std::vector<uint32_t>& spirv) {
    constexpr uint32_t kLoad = 61, kCopyObject = 83, kConstant = 43, kDecorate = 71, kBuiltIn = 11, kSubgroupSize = 36;
    uint32_t size = 0, loads = 0;
    std::map<uint32_t, uint32_t> constants;  // of 32, by type
    for (size_t at = 5; at < spirv.size(); at += spirv[at] >> 16) {
        const uint32_t op = spirv[at] & 0xFFFFu;
        if (op == kDecorate && spirv[at + 2] == kBuiltIn && spirv[at + 3] == kSubgroupSize) size = spirv[at + 1];
        if (op == kConstant && spirv[at + 3] == 32) constants[spirv[at + 1]] = spirv[at + 2];
        if (op != kLoad || size == 0 || spirv[at + 3] != size) continue;
        if (spirv[at] >> 16 != 4) throw std::runtime_error("a load with memory operands");
        spirv[at] = 4u << 16 | kCopyObject;
        spirv[at + 3] = constants.at(spirv[at + 1]);
        ++loads;
    }
    return loads;
}

class ClusterLanes : public testing::Test {
protected:
    /// Samples that the oracle answers otherwise.
    uint64_t wrong(std::vector<uint32_t> spirv, uint32_t split) {
        host::PassCache passes(test::passes().device());
        passes.substitute(kTraverse, std::move(spirv));
        host::FrameInputs inputs(passes, view_.frame, view_.pixels, view_.width);
        inputs.setLight(view_.light, host::Cull::none);
        host::Technique& technique = host::techniqueByName("ptsv");
        const std::array settings{std::string("split=") + (split == 0 ? "off" : std::to_string(split))};
        host::StructureCache structures;
        const auto got =
            technique.run(inputs, structures, host::Settings(technique.info().settings, settings), {.counters = false, .warmUp = false});
        uint64_t count = 0;
        for (size_t i = 0; i < want_.size(); ++i) count += got.visibility[i] != want_[i];
        return count;
    }
    uint64_t dark() const { return uint64_t(std::count(want_.begin(), want_.end(), GNO_VISIBILITY_SHADOW)); }

    CameraView view_ = scene();
    std::vector<uint32_t> want_ = oracleMask(view_);
};

TEST_F(ClusterLanes, TheSizeIsNotAsked) {
    std::vector<uint32_t> spirv = traversal(kAll);
    EXPECT_EQ(saySizeIs32(spirv), 0u);
    ASSERT_GT(dark(), 300u);
    EXPECT_EQ(wrong(spirv, 2), 0u);
}

TEST_F(ClusterLanes, AskingForItIsWrong) {
    std::vector<uint32_t> spirv = traversal(kAll, "lanes_.count = subgroupBallotBitCount(lanes_.ids);", "lanes_.count = gl_SubgroupSize;");
    EXPECT_EQ(wrong(spirv, 0), 0u) << "the size says the truth here";
    ASSERT_GT(saySizeIs32(spirv), 0u);
    const uint64_t lost = wrong(spirv, 0);
    std::printf("gl_SubgroupSize taken for the number of invocations, and 32: %lu of %lu dark samples are lost\n", lost, dark());
    EXPECT_GT(lost, dark() / 2);
}

// 0, 2, 3, 5, 6, ..: a hole at 1 already, so ids and ranks differ.
constexpr const char* kHoles = "gl_SubgroupInvocationID % 3u != 1u";

TEST_F(ClusterLanes, SomeOfThemAreMissing) {
    EXPECT_EQ(wrong(traversal(kHoles), 2), 0u);
    EXPECT_EQ(wrong(traversal("gl_SubgroupInvocationID < 3u"), 0), 0u);
    EXPECT_EQ(wrong(traversal("gl_SubgroupInvocationID == gl_SubgroupSize - 1u"), 0), 0u) << "one alone";
}

TEST_F(ClusterLanes, IdsAreNoRanks) {
    EXPECT_GT(wrong(traversal(kHoles, "lanes_.rank = subgroupBallotExclusiveBitCount(lanes_.ids);", "lanes_.rank = gl_SubgroupInvocationID;"), 0),
              0u);
    EXPECT_GT(wrong(traversal(kHoles, "if (!lanes_.gaps) return ballot_.x;", "return ballot_.x;"), 0), 0u);
}

}  // namespace
}  // namespace gno
