// SPDX-License-Identifier: MIT
// Shadow maps on the device against the oracle: away from silhouettes every sample is right, near them a few are wrong, fewer with more texels and
// with fitted views; without bias surfaces darken themselves, with too much of it light leaks below what stands on the ground.
#include <gtest/gtest.h>

#include <cstdio>

#include "validation/support/device_test.hpp"
#include "validation/tests/oracle_cases.hpp"

namespace gno {
namespace {

using host::cases::addBox;
using host::cases::addQuad;
using host::cases::snap;
using Strings = std::vector<std::string>;

constexpr float kOff = 0x1p-19f;  // samples lie that far off their surface
constexpr int kGrid = 48;         // samples along a side of a surface

/// A scene, and per sample two unit vectors of the surface it lies on.
struct Stage {
    test::Scene scene;
    std::vector<host::Light> lights;  ///< of the frame; only a spot light makes a difference
    std::vector<std::array<glm::vec3, 2>> tangents;
};

/// Samples all over a quad, on the side of its normal u x v.
void addSurface(Stage& stage, glm::vec3 corner, glm::vec3 u, glm::vec3 v) {
    const auto own = uint32_t(stage.scene.triangles.size());
    addQuad(stage.scene.triangles, corner, corner + u, corner + u + v, corner + v);
    const glm::vec3 normal = glm::normalize(glm::cross(u, v));
    for (int i = 0; i < kGrid; ++i)
        for (int k = 0; k < kGrid; ++k) {
            const float s = (float(i) + 0.37f) / kGrid, t = (float(k) + 0.61f) / kGrid;  // off the diagonal: s + eps != t
            const uint32_t half = s > t ? 0 : 1;                                         // addQuad: a b c, a c d
            stage.scene.samples.push_back({snap(glm::dvec3(corner + u * s + v * t + normal * kOff)), own + half});
            stage.tangents.push_back({glm::normalize(u), glm::normalize(v)});
        }
}

/// Ground, a square above it, and a wall that stands on it.
Stage square(glm::vec4 light) {
    Stage stage;
    stage.scene.light = light;
    addSurface(stage, {-0.75f, -0.5f, -0.75f}, {0, 0, 1.5f}, {1.5f, 0, 0});
    addQuad(stage.scene.triangles, {-0.1f, 0.0f, -0.15f}, {-0.1f, 0.0f, 0.2f}, {0.25f, 0.0f, 0.2f}, {0.25f, 0.0f, -0.15f});
    addBox(stage.scene.triangles, {-0.5f, -0.5f, -0.4f}, {-0.47f, -0.3f, 0.3f});
    return stage;
}

const glm::vec4 kPoint(0.3f, 0.8f, 0.1f, 1), kSun(0.5f, 1, 0.3125f, 0);

/// Six walls, seen from inside, a light in the middle and a box near each wall.
Stage room() {
    Stage stage;
    stage.scene.light = glm::vec4(0.0625f, -0.03125f, 0.046875f, 1);
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-0.75f, 0.75f}) {
            glm::vec3 corner(-0.75f), u(0), v(0), at(0.1f, -0.15f, 0.05f);
            corner[axis] = side;
            u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1.5f;
            side < 0 ? addSurface(stage, corner, u, v) : addSurface(stage, corner, v, u);
            at[axis] = side * 0.7f;
            addBox(stage.scene.triangles, at - 0.06f, at + 0.06f);
        }
    return stage;
}

host::TechniqueResult shoot(const Stage& stage, Strings settings) {
    host::Frame frame = test::frameOf(stage.scene);
    frame.lights = stage.lights;
    host::FrameInputs inputs(test::passes(), frame, stage.scene.samples, stage.scene.width);
    inputs.setLight(stage.scene.light, stage.scene.cull);
    host::Technique& technique = host::techniqueByName("shadow-map");
    host::StructureCache structures;
    host::TechniqueResult result =
        technique.run(inputs, structures, host::Settings(technique.info().settings, settings), {host::Precision::published, 1, true, true, false});
    result.visibility.resize(stage.scene.samples.size());
    return result;
}

uint64_t counter(const host::TechniqueResult& result, const std::string& name) {
    for (const auto& [key, value] : result.counters.more)
        if (key == name) return value;
    ADD_FAILURE() << "no counter " << name;
    return 0;
}

/// 1: the exact answer is another one `radius` further in some direction along the surface.
std::vector<uint8_t> nearSilhouette(const Stage& stage, const host::OracleAnswer& answer, float radius) {
    std::vector<uint8_t> result(stage.scene.samples.size(), 0);
    for (int direction = 0; direction < 8; ++direction)
        for (const float part : {0.35f, 0.7f, 1.0f}) {
            test::Scene moved = stage.scene;
            const float angle = float(direction) * 0.785398f;
            for (size_t i = 0; i < moved.samples.size(); ++i)
                moved.samples[i].position = snap(glm::dvec3(
                    moved.samples[i].position + part * radius * (std::cos(angle) * stage.tangents[i][0] + std::sin(angle) * stage.tangents[i][1])));
            const host::OracleAnswer other = test::ask(moved);
            for (size_t i = 0; i < result.size(); ++i) result[i] |= uint8_t(other.inShadow[i] != answer.inShadow[i]);
        }
    return result;
}

struct Tally {
    uint64_t wrong = 0, leaks = 0, falseDark = 0, wrongFar = 0, far = 0, dark = 0;
};

Tally tally(const Stage& stage, const host::TechniqueResult& result, const host::OracleAnswer& answer, std::span<const uint8_t> near) {
    Tally sum;
    for (size_t i = 0; i < near.size(); ++i) {
        const bool isWrong = result.visibility[i] != (answer.inShadow[i] ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT);
        sum.wrong += isWrong;
        sum.leaks += isWrong && answer.inShadow[i];
        sum.falseDark += isWrong && !answer.inShadow[i];
        sum.wrongFar += isWrong && !near[i];
        sum.far += !near[i];
        sum.dark += answer.inShadow[i];
        if (isWrong && !near[i] && sum.wrongFar == 1) {
            const glm::vec3 p = stage.scene.samples[i].position;
            std::printf("first wrong one: sample %zu at %g %g %g, in shadow %d\n", i, p.x, p.y, p.z, answer.inShadow[i]);
        }
    }
    return sum;
}

/// Width of a texel on the surfaces of these scenes, at most: views are 2 slopes wide at distances up to 1.3, or prisms 2 wide, and meet surfaces at
/// 30 degrees or more.
float texel(uint32_t map) { return 2.0f * 1.3f / float(map) / 0.5f; }

void expectRightAwayFromSilhouettes(const Stage& stage, const std::string& what, uint64_t views) {
    const host::OracleAnswer answer = test::ask(stage.scene);
    for (const uint32_t map : {512u, 2048u}) {
        const std::vector<uint8_t> near = nearSilhouette(stage, answer, 3 * texel(map));
        for (const char* fit : {"uniform", "focused"}) {
            const host::TechniqueResult result = shoot(stage, {"map=" + std::to_string(map), std::string("fit=") + fit});
            const Tally sum = tally(stage, result, answer, near);
            std::printf("%s, map %u, %s: %llu wrong (%llu leaks, %llu false dark) of %zu, %llu of them away from silhouettes (%llu)\n", what.c_str(),
                        map, fit, (unsigned long long)sum.wrong, (unsigned long long)sum.leaks, (unsigned long long)sum.falseDark, near.size(),
                        (unsigned long long)sum.wrongFar, (unsigned long long)sum.far);
            EXPECT_EQ(sum.wrongFar, 0u) << what << " " << map << " " << fit;
            EXPECT_GT(sum.dark, near.size() / 100);
            EXPECT_GT(sum.far, near.size() / 2) << "nearly everything is near a silhouette: this tests nothing";
            EXPECT_EQ(counter(result, "views"), views);
            EXPECT_EQ(counter(result, "texels"), views * map * map);
            EXPECT_EQ(counter(result, "triangles_drawn"), views * stage.scene.triangles.size());
            EXPECT_EQ(result.bytes.at(0).second, 4 * views * map * map);
        }
    }
}

TEST(ShadowMap, PointLight) { expectRightAwayFromSilhouettes(square(kPoint), "point", 1); }
TEST(ShadowMap, DirectionalLight) { expectRightAwayFromSilhouettes(square(kSun), "directional", 1); }
TEST(ShadowMap, LightInARoomUsesAllSixFaces) { expectRightAwayFromSilhouettes(room(), "room", 6); }

host::Light spotAt(glm::vec4 position, glm::vec3 axis, float cone) {
    host::Light light;
    light.kind = host::Light::Kind::spot;
    light.homogeneous = position;
    light.axis = glm::normalize(axis);
    light.outerCone = cone;
    return light;
}

/// The ground is not parallel to the map: a light at infinity, and a spot that looks aslant.
std::vector<Stage> slanting() {
    std::vector<Stage> result{square(kPoint), square(kSun)};
    result[0].lights = {spotAt(kPoint, {-0.6f, -1, -0.4f}, 1.1f)};
    return result;
}

TEST(ShadowMap, SpotLightAnswersOutsideOfItsConeToo) {
    Stage stage = square(kPoint);
    stage.lights = {spotAt(kPoint, {-0.1f, -1, 0.05f}, 0.3f)};
    expectRightAwayFromSilhouettes(stage, "spot", 2);
}

TEST(ShadowMap, ASampleBehindEveryCasterOrBesideThemAll) {
    for (const glm::vec4 light : {kPoint, kSun}) {
        Stage stage = square(light);
        stage.scene.triangles.erase(stage.scene.triangles.begin(),
                                    stage.scene.triangles.begin() + 2);  // the ground casts no more: samples lie beyond every caster
        for (host::OracleSample& s : stage.scene.samples) s.own = host::kNoCaster;
        const host::OracleAnswer answer = test::ask(stage.scene);
        const std::vector<uint8_t> near = nearSilhouette(stage, answer, 3 * texel(512));
        for (const char* fit : {"fit=uniform", "fit=focused"})
            EXPECT_EQ(tally(stage, shoot(stage, {"map=512", fit}), answer, near).wrongFar, 0u) << fit << " " << light.w;
    }
}

TEST(ShadowMap, WithoutBiasSurfacesDarkenThemselves) {
    for (const Stage& stage : slanting()) {
        const host::OracleAnswer answer = test::ask(stage.scene);
        const std::vector<uint8_t> near = nearSilhouette(stage, answer, 3 * texel(512));
        const Tally none = tally(stage, shoot(stage, {"map=512", "bias=0", "constant_bias=0"}), answer, near);
        const Tally slope = tally(stage, shoot(stage, {"map=512", "bias=1.25", "constant_bias=0"}), answer, near);
        const Tally constant = tally(stage, shoot(stage, {"map=512", "bias=0", "constant_bias=2"}), answer, near);
        std::printf("light w %g: away from silhouettes %llu wrong without bias, %llu with bias 1.25, %llu with constant bias 2\n",
                    stage.scene.light.w, (unsigned long long)none.wrongFar, (unsigned long long)slope.wrongFar,
                    (unsigned long long)constant.wrongFar);
        EXPECT_GT(none.falseDark, near.size() / 10);
        EXPECT_EQ(slope.wrongFar, 0u) << "a texel and a quarter is enough for a plane";
        EXPECT_EQ(constant.wrongFar, 0u) << "so is a constant one of two texels, on slopes below 45 degrees";
    }
}

TEST(ShadowMap, TooMuchBiasLeaks) {
    for (const Stage& stage : slanting()) {
        const host::OracleAnswer answer = test::ask(stage.scene);
        const std::vector<uint8_t> near = nearSilhouette(stage, answer, 3 * texel(512));
        const Tally usual = tally(stage, shoot(stage, {"map=512"}), answer, near);
        const Tally slope = tally(stage, shoot(stage, {"map=512", "bias=64"}), answer, near);
        const Tally constant = tally(stage, shoot(stage, {"map=512", "constant_bias=64"}), answer, near);
        std::printf("light w %g: leaks %llu by default, %llu with bias 64, %llu with constant bias 64\n", stage.scene.light.w,
                    (unsigned long long)usual.leaks, (unsigned long long)slope.leaks, (unsigned long long)constant.leaks);
        for (const Tally& much : {slope, constant}) {
            EXPECT_GT(much.leaks, 2 * usual.leaks);
            EXPECT_GT(much.wrongFar, 0u) << "the wall's shadow parts from the wall";
        }
    }
}

TEST(ShadowMap, MoreBiasNeverMeansMoreDarkSamples) {
    for (const Stage& stage : slanting())
        for (const std::string key : {"bias=", "constant_bias="}) {
            uint64_t before = ~0ull;
            for (const char* value : {"0", "0.5", "1", "4", "16", "64"}) {
                const auto mask = shoot(stage, {"map=512", key + value}).visibility;
                const auto dark = uint64_t(std::count(mask.begin(), mask.end(), GNO_VISIBILITY_SHADOW));
                EXPECT_LE(dark, before) << key << value;
                before = dark;
            }
        }
}

TEST(ShadowMap, StagesAgree) {
    for (const Stage& stage : {square(kPoint), square(kSun), room()})
        EXPECT_EQ(shoot(stage, {"map=512", "stage=fragment"}).visibility, shoot(stage, {"map=512"}).visibility);
}

TEST(ShadowMap, CulledAndEdgeOnCastersAreNotDrawn) {
    Stage stage = square(glm::vec4(0, 1, 0, 0));
    const auto all = stage.scene.triangles.size();
    const uint64_t edgeOn = 8;  // the wall's sides
    EXPECT_EQ(counter(shoot(stage, {"map=512"}), "triangles_drawn"), all - edgeOn);
    EXPECT_EQ(
        counter(shoot(stage, {"map=512", "faces=front"}), "triangles_drawn") + counter(shoot(stage, {"map=512", "faces=back"}), "triangles_drawn"),
        all - edgeOn);

    stage.scene.closed.assign(all, 1);
    stage.scene.cull = host::Cull::front;  // ground, square, the wall's top
    const host::TechniqueResult culled = shoot(stage, {"map=512"});
    EXPECT_EQ(counter(culled, "triangles_drawn"), 2u);
    const host::OracleAnswer answer = test::ask(stage.scene);
    const std::vector<uint8_t> near = nearSilhouette(stage, answer, 3 * texel(512));
    EXPECT_EQ(tally(stage, culled, answer, near).wrongFar, 0u);
}

TEST(ShadowMap, FacesAreThoseTheLightSees) {
    const Stage stage = square(kSun);
    const auto both = shoot(stage, {"map=512"}).visibility, front = shoot(stage, {"map=512", "faces=front"}).visibility,
               back = shoot(stage, {"map=512", "faces=back"}).visibility;
    EXPECT_EQ(front, both) << "what is nearest to the light faces it, but where bias is in play";
    const auto dark = [](const std::vector<uint32_t>& mask) { return std::count(mask.begin(), mask.end(), GNO_VISIBILITY_SHADOW); };
    EXPECT_LT(dark(back), dark(both)) << "the square is a sheet: its front alone casts";
    EXPECT_GT(dark(back), 0) << "the wall is closed";
}

TEST(ShadowMap, NothingToDo) {
    Stage stage = square(kPoint);
    stage.scene.samples = {{{0, 0, 0}, GNO_BACKGROUND}, {{0, 0, 0}, GNO_FACING_AWAY}};
    const host::TechniqueResult none = shoot(stage, {});
    EXPECT_EQ(none.visibility, (std::vector<uint32_t>{GNO_VISIBILITY_BACKGROUND, GNO_VISIBILITY_FACING_AWAY}));
    EXPECT_EQ(counter(none, "views"), 0u);
    EXPECT_LE(none.bytes.at(0).second, 4u) << "no view, no map";
    for (const glm::vec4 light : {kPoint, kSun}) {
        Stage empty = square(light);
        empty.scene.triangles.clear();
        for (host::OracleSample& s : empty.scene.samples) s.own = host::kNoCaster;
        const auto mask = shoot(empty, {"map=512"}).visibility;
        EXPECT_EQ(std::count(mask.begin(), mask.end(), GNO_VISIBILITY_LIT), std::ptrdiff_t(mask.size()));
    }
}

/// A shipped scene: more texels and fitted views make fewer samples wrong.
TEST(ShadowMap, MoreTexelsAndFittedViewsAreBetter) {
    const host::Frame frame = host::SceneFile::load("scenes/show_garden.glb").evaluate(0, 0);
    host::FrameInputs inputs(test::passes(), frame, 128, 128);
    host::Technique& technique = host::techniqueByName("shadow-map");
    for (size_t light = 0; light < 2; ++light) {
        inputs.setLight(frame.lights.at(light).homogeneous, host::Cull::none);
        std::vector<host::OracleSample> samples;
        for (const host::OracleSample& s : inputs.pixels())
            if (s.own <= GNO_NO_CASTER) samples.push_back(s);
        const host::OracleAnswer answer = host::makeOracle()->ask({frame.triangles, {}, inputs.light(), samples}, [](double) {});
        const auto wrong = [&](const Strings& settings) {
            host::StructureCache structures;
            const auto mask = technique
                                  .run(inputs, structures, host::Settings(technique.info().settings, settings),
                                       {host::Precision::published, 1, false, false, false})
                                  .visibility;
            uint64_t sum = 0;
            size_t sample = 0;
            for (size_t i = 0; i < mask.size(); ++i)
                if (inputs.pixels()[i].own <= GNO_NO_CASTER)
                    sum += mask[i] != (answer.inShadow[sample++] ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT);
            return sum;
        };
        uint64_t coarser = ~0ull;
        for (const char* map : {"512", "2048", "4096"}) {
            const uint64_t uniform = wrong({std::string("map=") + map, "fit=uniform"}), focused = wrong({std::string("map=") + map, "fit=focused"});
            std::printf("show_garden, light %zu, map %s: %llu wrong uniform, %llu focused, of %zu\n", light, map, (unsigned long long)uniform,
                        (unsigned long long)focused, samples.size());
            EXPECT_LE(focused, uniform) << map;
            EXPECT_LT(focused, coarser) << map;
            EXPECT_GT(focused, 0u) << "a shadow map without an error: is it compared at all?";
            coarser = focused;
        }
    }
}

}  // namespace
}  // namespace gno
