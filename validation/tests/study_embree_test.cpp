// SPDX-License-Identifier: MIT
// Embree as a peer of the study: right where no sign is near zero, in both modes; timed; asked about the same casters; on all threads.
#include <gtest/gtest.h>

#include <chrono>
#include <mutex>
#include <set>
#include <thread>

#include "host_min/error.hpp"
#include "validation/oracle/parallel.hpp"
#include "validation/study/peer.hpp"
#include "validation/tests/oracle_cases.hpp"

namespace gno::study {
namespace {

using host::cases::HardCase;
using host::cases::Random;
using host::cases::snap;

constexpr uint32_t kSeed = 1313;

const Peer& embree() {
    for (const auto& peer : peers())
        if (peer->name() == "embree") return *peer;
    throw std::logic_error("no peer is called embree");
}

/// Casters anywhere, samples anywhere: every third lies behind a caster that is its own.
HardCase soup(bool directional, size_t casters, size_t samples) {
    Random random(kSeed);
    HardCase scene;
    scene.light = directional ? glm::vec4(0.375f, 1, 0.25f, 0) : glm::vec4(0.125f, 0.875f, -0.25f, 1);
    while (scene.triangles.size() < casters) {
        const glm::dvec3 at = random.inCube(0.8);
        const auto corner = [&] { return snap(at + random.inCube(0.2)); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        scene.triangles.push_back({a, b, c});
    }
    while (scene.samples.size() < samples) {
        const uint32_t own = random.below(uint32_t(casters));
        const host::Triangle& t = scene.triangles[own];
        const glm::dvec3 middle = (glm::dvec3(t.a) + glm::dvec3(t.b) + glm::dvec3(t.c)) / 3.0;
        const glm::dvec3 away = directional ? -glm::dvec3(scene.light) : middle - glm::dvec3(scene.light);
        if (scene.samples.size() % 3 == 0)
            scene.samples.push_back({snap(middle + 0.0625 * away), own});
        else
            scene.samples.push_back({snap(random.inCube()), host::kNoCaster});
    }
    return scene;
}

uint64_t number(const host::NamedNumbers& list, const std::string& name) {
    for (const auto& [key, value] : list)
        if (key == name) return value;
    throw std::out_of_range(name);
}

void expectTheOracles(const HardCase& scene) {
    const host::OracleAnswer want = host::makeOracle()->ask(scene.question(), [](double) {});
    const auto dark = size_t(std::count(want.inShadow.begin(), want.inShadow.end(), 1));
    EXPECT_GT(dark, scene.samples.size() / 10);
    EXPECT_LT(dark, scene.samples.size() * 9 / 10);
    for (const std::string& precision : embree().precisions()) {
        const PeerAnswer got = embree().run(scene.question(), precision);
        ASSERT_EQ(got.inShadow.size(), want.inShadow.size());
        size_t wrong = 0;
        for (size_t i = 0; i < want.inShadow.size(); ++i) wrong += got.inShadow[i] != want.inShadow[i];
        EXPECT_EQ(wrong, 0u) << precision << ", seed " << kSeed;
    }
}

TEST(StudyEmbree, EqualsTheOracleWhereNoSignIsNearZero) {
    EXPECT_EQ(embree().precisions(), (std::vector<std::string>{"fp32", "robust"}));
    for (const bool directional : {false, true}) expectTheOracles(soup(directional, 300, 5003));
}

TEST(StudyEmbree, ThePacketsLastOneMayBeShort) {
    const HardCase whole = soup(false, 300, 40);
    const auto want = embree().run(whole.question(), "fp32").inShadow;
    for (const size_t count : {1, 7, 8, 9, 33}) {
        HardCase part = whole;
        part.samples.resize(count);
        EXPECT_EQ(embree().run(part.question(), "fp32").inShadow, std::vector<uint8_t>(want.begin(), want.begin() + ptrdiff_t(count))) << count;
    }
}

TEST(StudyEmbree, TheOwnCasterNeverShadows) {
    HardCase scene = soup(false, 300, 3000);
    const auto with = embree().run(scene.question(), "robust").inShadow;
    for (host::OracleSample& sample : scene.samples) sample.own = host::kNoCaster;
    const auto without = embree().run(scene.question(), "robust").inShadow;
    size_t changed = 0;
    for (size_t i = 0; i < with.size(); ++i) {
        EXPECT_LE(with[i], without[i]);
        EXPECT_TRUE(i % 3 != 0 || without[i] == 1) << "sample " << i << " lies behind its own caster";
        changed += with[i] != without[i];
    }
    EXPECT_GT(changed, 100u);
}

TEST(StudyEmbree, CastersLeftOutAreNotMet) {
    HardCase scene = soup(true, 300, 3000);
    for (size_t i = 0; i < scene.triangles.size(); ++i) scene.isCaster.push_back(i % 3 == 0);
    expectTheOracles(scene);
    scene.isCaster.assign(scene.triangles.size(), 0);
    for (const std::string& precision : embree().precisions())
        EXPECT_EQ(embree().run(scene.question(), precision).inShadow, std::vector<uint8_t>(3000, 0)) << precision;
    scene.triangles.clear();
    scene.isCaster.clear();
    for (host::OracleSample& sample : scene.samples) sample.own = host::kNoCaster;
    EXPECT_EQ(embree().run(scene.question(), "fp32").inShadow, std::vector<uint8_t>(3000, 0));
    scene.samples.clear();
    EXPECT_TRUE(embree().run(scene.question(), "fp32").inShadow.empty());
}

TEST(StudyEmbree, ASampleAtTheLightIsLit) {
    HardCase scene = soup(false, 300, 1);
    scene.samples = {{glm::vec3(scene.light), host::kNoCaster}};
    for (const std::string& precision : embree().precisions())
        EXPECT_EQ(embree().run(scene.question(), precision).inShadow, std::vector<uint8_t>{0});
}

TEST(StudyEmbree, TimesAndBytes) {
    const HardCase scene = soup(false, 5000, 20000);
    for (const std::string& precision : embree().precisions()) {
        const PeerAnswer answer = embree().run(scene.question(), precision);
        ASSERT_EQ(answer.passes.size(), 2u);
        EXPECT_EQ(answer.passes[0].name, "build");
        EXPECT_TRUE(host::isBuildPass(answer.passes[0].name));
        EXPECT_EQ(answer.passes[1].name, "query");
        EXPECT_FALSE(host::isBuildPass(answer.passes[1].name));
        for (const host::RecordPass& pass : answer.passes) EXPECT_GT(pass.ms, 0) << pass.name;
        EXPECT_GT(number(answer.bytes, "hierarchy"), 5000u * 48u);  // nine floats and three indices of each caster at the least
    }
}

/// What asks the samples: as many threads as the machine has, each with a part.
TEST(StudyEmbree, AllThreads) {
    std::mutex mutex;
    std::set<std::thread::id> seen;
    const auto work = [&](size_t, size_t) {
        {
            const std::lock_guard lock(mutex);
            seen.insert(std::this_thread::get_id());
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    };
    host::oracle::forEachChunk(400 * 1024, work, {});
    EXPECT_EQ(seen.size(), std::max(1u, std::thread::hardware_concurrency()));
}

TEST(StudyEmbree, AnUnknownPrecisionListsTheKnownOnes) {
    const HardCase scene = soup(false, 10, 10);
    try {
        (void)embree().run(scene.question(), "certified");
        FAIL() << "no complaint";
    } catch (const host::InputError& error) {
        for (const char* part : {"embree", "certified", "fp32", "robust"})
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace gno::study
