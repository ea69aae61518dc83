// SPDX-License-Identifier: MIT
// Where a scene stands in the world does not matter: 2^20, 2^23, 2^24 and ten million units away from the origin it has the shadows that it has at
// home.
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <sstream>

#include "host_min/scene/grid.hpp"
#include "validation/hard_cases/scene_maker.hpp"
#include "validation/tests/scene_builder.hpp"

namespace gno::hard {
namespace {

/// A town of 1,024 units whose corners are even numbers, so that fp32 holds them up to 2^25, moved by `far` units along x and -z.
test::Scene townAt(double far) {
    Random random(5);
    const glm::dvec3 move(far, 0, -far);
    const host::Grid grid = host::Grid::around(move - 600.0, move + 600.0);
    const auto at = [&](double x, double y, double z) {
        const glm::dvec3 world = move + glm::dvec3(x, y, z);
        EXPECT_EQ(world, glm::dvec3(glm::vec3(world))) << "not an fp32 position";
        return grid.snap(world);
    };
    const auto even = [&](int range) { return 2.0 * (double(random.below(uint32_t(range))) - range / 2); };
    test::Scene scene;
    scene.light = {at(40, 400, -64), 1};
    addQuad(scene.triangles, at(-512, 0, -512), at(-512, 0, 512), at(512, 0, 512), at(512, 0, -512));
    for (int i = 0; i < 60; ++i) {
        const double x = even(440), z = even(440);
        addBox(scene.triangles, at(x, 0, z), at(x + 10 + 2 * random.below(20), 2.0 * (1 + random.below(60)), z + 10 + 2 * random.below(20)));
    }
    while (scene.samples.size() < 1500) {
        const glm::dvec3 p(even(500), random.below(2) ? 0 : 2.0 * random.below(60), even(500));
        random.below(2) ? addOn(scene, random.below(2), glm::dvec3(at(p.x, 0, p.z))) : addFree(scene, glm::dvec3(at(p.x, p.y, p.z)));
    }
    return scene;
}

TEST(FarFromOrigin, APowerOfTwoMovesNothingOnTheGrid) {
    const test::Scene home = townAt(0);
    const auto want = test::run(home, "d-hybrid", host::Precision::certified).visibility;
    const host::OracleAnswer answer = test::ask(home);
    const auto dark = std::count(want.begin(), want.end(), GNO_VISIBILITY_SHADOW);
    EXPECT_GT(dark, 150);
    EXPECT_LT(dark, 1350);
    for (const double far : {0x1p20, 0x1p24}) {
        const test::Scene away = townAt(far);
        ASSERT_EQ(away.triangles.size(), home.triangles.size());
        EXPECT_EQ(std::memcmp(away.triangles.data(), home.triangles.data(), home.triangles.size() * sizeof(Triangle)), 0) << far;
        for (const auto& technique : host::techniques()) {
            const auto& rungs = technique->info().precisions;
            if (std::find(rungs.begin(), rungs.end(), host::Precision::certified) == rungs.end()) continue;
            const host::TechniqueResult result = test::run(away, technique->info().name, host::Precision::certified);
            EXPECT_EQ(result.visibility, want) << technique->info().name << " at " << far;
            EXPECT_EQ(test::compare(result, answer).wrong, 0u) << technique->info().name << " at " << far;
        }
    }
}

/// The shipped table fan below a new root node that moves it.
std::string movedTableFan(glm::dvec3 by) {
    std::ifstream file("scenes/table_fan/table_fan.glb", std::ios::binary);
    const std::string bytes = (std::ostringstream() << file.rdbuf()).str();
    if (bytes.size() < 28) throw std::runtime_error("cannot read scenes/table_fan/table_fan.glb: run this test in the project's folder");
    const auto word = [&](size_t at) {
        uint32_t value = 0;
        std::memcpy(&value, bytes.data() + at, 4);
        return size_t(value);
    };
    nlohmann::json json = nlohmann::json::parse(bytes.substr(20, word(12)));
    const size_t binary = 20 + word(12);
    nlohmann::json& roots = json["scenes"][json.value("scene", 0)]["nodes"];
    json["nodes"].push_back({{"translation", {by.x, by.y, by.z}}, {"children", roots}});
    roots = nlohmann::json::array({json["nodes"].size() - 1});
    return host::test::glbOf(json.dump(), bytes.substr(binary + 8, word(binary)));
}

struct Shot {
    host::Frame frame;
    std::vector<uint32_t> mask;
    uint64_t samples = 0, dark = 0;
};

/// 96 x 96 pixels of it, certified and checked.
Shot shoot(glm::dvec3 by) {
    constexpr uint32_t kSize = 96;
    Shot shot;
    shot.frame = host::test::loadBytes(movedTableFan(by)).evaluate(0, 0);
    host::FrameInputs inputs(test::passes(), shot.frame, kSize, kSize);
    inputs.setLight(shot.frame.lights.at(0).homogeneous, host::Cull::none);
    host::Technique& technique = host::techniqueByName("d-hybrid");
    host::StructureCache structures;
    shot.mask =
        technique.run(inputs, structures, host::Settings(technique.info().settings, {}), {host::Precision::certified, 1, false, false}).visibility;
    std::vector<host::OracleSample> samples;
    std::vector<uint32_t> got;
    for (size_t i = 0; i < shot.mask.size(); ++i) {
        if (inputs.pixels()[i].own > GNO_NO_CASTER) continue;
        samples.push_back(inputs.pixels()[i]);
        got.push_back(shot.mask[i]);
    }
    const host::OracleAnswer answer = host::makeOracle()->ask({shot.frame.triangles, {}, inputs.light(), samples}, [](double) {});
    uint64_t wrong = 0;
    for (size_t i = 0; i < samples.size(); ++i) wrong += got[i] != (answer.inShadow[i] ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT);
    EXPECT_EQ(wrong, 0u) << "at " << by.x;
    EXPECT_EQ(answer.selfShadowed, 0u) << "at " << by.x;
    shot.samples = samples.size();
    shot.dark = uint64_t(std::count(answer.inShadow.begin(), answer.inShadow.end(), uint8_t(1)));
    return shot;
}

uint64_t differences(const std::vector<uint32_t>& a, const std::vector<uint32_t>& b) {
    uint64_t count = a.size() == b.size() ? 0 : a.size() + b.size();
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) count += a[i] != b[i];
    return count;
}

TEST(FarFromOrigin, ARealScene) {
    const Shot home = shoot(glm::dvec3(0));
    EXPECT_GT(home.samples, 1000u);
    EXPECT_GT(home.dark, 50u);
    for (const double by : {0x1p23, 1e7}) {
        const Shot away = shoot(glm::dvec3(by, -by, by));
        ASSERT_EQ(away.frame.triangles.size(), home.frame.triangles.size());
        uint64_t moved = 0;
        for (size_t i = 0; i < home.frame.triangles.size(); ++i)
            moved += std::memcmp(&away.frame.triangles[i], &home.frame.triangles[i], sizeof(Triangle)) != 0;
        const uint64_t pixels = differences(away.mask, home.mask);
        std::printf("moved by %.0f: %llu of %zu triangles differ on the grid, %llu of %zu pixels\n", by, static_cast<unsigned long long>(moved),
                    home.frame.triangles.size(), static_cast<unsigned long long>(pixels), home.mask.size());
        EXPECT_EQ(moved, 0u);  // both distances are multiples of the step that a grid's centre is rounded to
        EXPECT_EQ(pixels, 0u);
    }
}

}  // namespace
}  // namespace gno::hard
