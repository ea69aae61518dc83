// SPDX-License-Identifier: MIT
// What the oracle reports besides yes and no: own triangles, self-shadowing, the witness, progress, and questions it refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "host_min/error.hpp"
#include "validation/oracle/definition.hpp"
#include "validation/oracle/parallel.hpp"
#include "validation/oracle/witness.hpp"
#include "validation/tests/oracle_cases.hpp"

namespace {

using namespace gno::host;

OracleAnswer ask(const cases::HardCase& c) { return makeOracle()->ask(c.question(), {}); }

const Triangle kLow{{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0, 0.5f, 0}};
const Triangle kHigh{{-0.5f, -0.5f, 0.25f}, {0.5f, -0.5f, 0.25f}, {0, 0.5f, 0.25f}};
const glm::vec3 kBelow{0, 0, -0x1p-40f};
const glm::vec4 kSun{0, 0, 1, 0}, kLamp{0, 0, 0.75f, 1};

class Own : public testing::TestWithParam<glm::vec4> {};

TEST_P(Own, NeverShadowsItsSampleButIsCounted) {
    const OracleAnswer own = ask({"", GetParam(), {kLow}, {}, {{kBelow, 0}}});
    EXPECT_EQ(own.inShadow[0], 0);
    EXPECT_EQ(own.caster[0], kNoCaster);
    EXPECT_EQ(own.selfShadowed, 1u);
    const OracleAnswer none = ask({"", GetParam(), {kLow}, {}, {{kBelow, kNoCaster}}});
    EXPECT_EQ(none.inShadow[0], 1);
    EXPECT_EQ(none.caster[0], 0u);
    EXPECT_EQ(none.selfShadowed, 0u);
}

TEST_P(Own, IsNotCountedOnTheLitSideOrOnItsPlane) {
    EXPECT_EQ(ask({"", GetParam(), {kLow}, {}, {{{0, 0, 0}, 0}, {{0, 0, 0x1p-40f}, 0}}}).selfShadowed, 0u);
}

TEST_P(Own, IsNotCountedWhenAnotherCasterShadows) {
    const OracleAnswer answer = ask({"", GetParam(), {kLow, kHigh}, {}, {{kBelow, 0}}});
    EXPECT_EQ(answer.inShadow[0], 1);
    EXPECT_EQ(answer.caster[0], 1u);
    EXPECT_EQ(answer.selfShadowed, 0u);
}

TEST_P(Own, IsNotCountedWhenItIsCulledAndCulledCastersCastNothing) {
    const OracleAnswer culled = ask({"", GetParam(), {kLow, kHigh}, {0, 0}, {{kBelow, 0}, {kBelow, kNoCaster}}});
    EXPECT_EQ(culled.inShadow, (std::vector<uint8_t>{0, 0}));
    EXPECT_EQ(culled.selfShadowed, 0u);
    const OracleAnswer half = ask({"", GetParam(), {kLow, kHigh}, {0, 1}, {{kBelow, 0}, {kBelow, 1}}});
    EXPECT_EQ(half.caster, (std::vector<uint32_t>{1, kNoCaster}));
    EXPECT_EQ(half.selfShadowed, 1u);
}

TEST_P(Own, OfADuplicateIsShadowedByItsTwin) {
    const OracleAnswer answer = ask({"", GetParam(), {kLow, kLow}, {}, {{kBelow, 0}, {kBelow, 1}}});
    EXPECT_EQ(answer.caster, (std::vector<uint32_t>{1, 0}));
}

INSTANTIATE_TEST_SUITE_P(BothLights, Own, testing::Values(kSun, kLamp),
                         [](const auto& light) { return std::string(light.param.w != 0 ? "Lamp" : "Sun"); });

// A height field and samples well clear of it: nothing here is close.
cases::HardCase easyScene(glm::vec4 light) {
    cases::Random random(1);
    cases::HardCase c{"easy", light, cases::heightField(16, random), {}, {}};
    while (c.samples.size() < 5000) {
        c.samples.push_back({cases::snap(random.inCube(0.9) * glm::dvec3(1, 0.2, 1) - glm::dvec3(0, 0.5, 0)), kNoCaster});
    }
    return c;
}

TEST(Witness, AgreesOnEasyScenes) {
    for (const glm::vec4 light : {glm::vec4(0.1f, 0.8f, 0.05f, 1), glm::vec4(0.3f, 1, 0.2f, 0)}) {
        cases::HardCase c = easyScene(light);
        for (int axis = 0; axis < 3; ++axis) c.light[axis] = cases::snap(c.light[axis]);
        const OracleAnswer answer = ask(c);
        EXPECT_EQ(answer.witnessDisagreements, 0u);
        const auto shadowed = std::count(answer.inShadow.begin(), answer.inShadow.end(), uint8_t(1));
        EXPECT_GT(shadowed, 500);
        EXPECT_LT(shadowed, 4500);
    }
}

TEST(Witness, SkipsOwnAndCulledCasters) {
    const cases::HardCase c{"", kLamp, {kHigh, kLow}, {0, 1}, {{{0, 0, -0.25f}, 0}, {{0, 0, -0.25f}, 1}, {{0, 0, -0.25f}, kNoCaster}}};
    EXPECT_EQ(oracle::askWitness(c.question(), {}), (std::vector<uint8_t>{1, 0, 1}));
    EXPECT_EQ(ask(c).inShadow, (std::vector<uint8_t>{1, 0, 1}));
}

TEST(Witness, ItsDisagreementsAreCountedOnTies) {
    // Samples within rounding of a tilted caster's plane: the sign of their side is lost in fp32.
    cases::Random random(3);
    cases::HardCase c{"",
                      {0.25f, 0.9375f, 0.125f, 1},
                      {{cases::snap({-0.9, -0.31, -0.83}), cases::snap({0.1, 0.47, 0.77}), cases::snap({0.93, -0.2, -0.6})}},
                      {},
                      {}};
    const Triangle t = c.triangles[0];
    for (int i = 0; i < 2000; ++i) {
        const double s = random.real(0, 1), r = random.real(0, 1 - s);
        const glm::dvec3 a(t.a);
        c.samples.push_back({cases::snap(a + s * (glm::dvec3(t.b) - a) + r * (glm::dvec3(t.c) - a)), kNoCaster});
    }
    const OracleAnswer answer = ask(c);
    const std::vector<uint8_t> witness = oracle::askWitness(c.question(), {}), exact = oracle::bruteForce(c.question()).inShadow;
    uint64_t different = 0;
    for (size_t i = 0; i < exact.size(); ++i) different += exact[i] != witness[i];
    EXPECT_GT(different, 0u);
    EXPECT_EQ(answer.witnessDisagreements, different);
    EXPECT_EQ(answer.inShadow, exact);
}

TEST(Answer, IsTheSameEveryTime) {
    const cases::HardCase c = easyScene({0.125f, 0.75f, 0, 1});
    const OracleAnswer first = ask(c), second = ask(c);
    EXPECT_EQ(first.inShadow, second.inShadow);
    EXPECT_EQ(first.caster, second.caster);
    EXPECT_GT(first.seconds, 0);
    EXPECT_GT(first.witnessSeconds, 0);
}

TEST(Answer, OfNoSampleIsEmpty) {
    const OracleAnswer answer = ask({"", kSun, {kLow}, {}, {}});
    EXPECT_TRUE(answer.inShadow.empty());
    EXPECT_TRUE(answer.caster.empty());
}

TEST(Progress, RisesFromZeroToOneOnTheCallingThread) {
    const cases::HardCase c = easyScene(kSun);
    std::vector<double> seen;
    const auto here = std::this_thread::get_id();
    makeOracle()->ask(c.question(), [&](double part) {
        EXPECT_EQ(std::this_thread::get_id(), here);
        seen.push_back(part);
    });
    ASSERT_GE(seen.size(), 2u);
    EXPECT_EQ(seen.front(), 0);
    EXPECT_EQ(seen.back(), 1);
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
}

TEST(Progress, WhatItThrowsStopsTheOracle) {
    const cases::HardCase c = easyScene(kSun);
    for (const double after : {0.0, 0.5, 0.95}) {
        const auto stop = [&](double part) {
            if (part >= after) throw WorkError("stopped");
        };
        EXPECT_THROW(makeOracle()->ask(c.question(), stop), WorkError) << after;
    }
}

TEST(Chunks, CoverTheRangeOnce) {
    std::vector<std::atomic<int>> seen(10007);
    const auto mark = [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) ++seen[i];
    };
    oracle::forEachChunk(seen.size(), mark, {});
    EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](const auto& s) { return s == 1; }));
}

TEST(Chunks, StopAtTheFirstErrorOfWorkOrProgress) {
    struct Stop {};
    EXPECT_THROW(oracle::forEachChunk(1u << 20, [](size_t, size_t) { throw Stop(); }, {}), Stop);
    std::atomic<size_t> done = 0;
    const auto slow = [&](size_t begin, size_t end) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        done += end - begin;
    };
    EXPECT_THROW(oracle::forEachChunk(1u << 20, slow, [](double) { throw Stop(); }), Stop);
    EXPECT_LT(done, 1u << 18);  // about 0.1 s of work, then an end
}

TEST(Refused, PositionsOffTheGrid) {
    EXPECT_THROW(ask({"", kSun, {kLow}, {}, {{{0x1p-41f, 0, 0}, 0}}}), WorkError);
    EXPECT_THROW(ask({"", kSun, {kLow}, {}, {{{0, 3, 0}, 0}}}), WorkError);
    EXPECT_THROW(ask({"", kSun, {kLow}, {}, {{{0, NAN, 0}, 0}}}), WorkError);
    EXPECT_THROW(ask({"", kSun, {{{0, 0, 0x1p-60f}, {1, 0, 0}, {0, 1, 0}}}, {}, {}}), WorkError);
    EXPECT_THROW(ask({"", {0, INFINITY, 0, 1}, {kLow}, {}, {}}), WorkError);
    EXPECT_THROW(ask({"", {0, 0x1p-50f, 1, 0}, {kLow}, {}, {}}), WorkError);
}

TEST(Refused, QuestionsThatContradictThemselves) {
    EXPECT_THROW(ask({"", kSun, {kLow}, {1, 1}, {}}), WorkError);
    EXPECT_THROW(ask({"", kSun, {kLow}, {}, {{{0, 0, 0}, 1}}}), WorkError);
    EXPECT_THROW(ask({"", {0, 0, 0, 0}, {kLow}, {}, {}}), WorkError);
    EXPECT_THROW(ask({"", {0, 0, 1, 0.5f}, {kLow}, {}, {}}), WorkError);
}

/// Two layers of half-transparent glass over a sample; who counts, and what comes out.
struct Glass {
    std::vector<Triangle> triangles{kLow, kHigh};
    std::vector<uint8_t> isCaster;
    std::vector<uint32_t> surfaceOf{0, 1};
    std::vector<Surface> surfaces{Surface{}, Surface{}};
    MaterialSet look;
    std::vector<OracleSample> samples{{kBelow, kNoCaster}};

    Glass() {
        Material& material = look.materials.emplace_back();
        material.alpha = Material::Alpha::blend;
        material.baseColor = glm::vec4(1, 1, 1, 0.2f);  // alpha 51 of 255: a fifth is lost
    }
    [[nodiscard]] OracleQuestion question(glm::vec4 light) const { return {triangles, isCaster, light, samples, surfaceOf, surfaces, &look}; }
};

constexpr uint32_t kOneLayer = 21098;  // round(-log2(204 / 255) * 2^16)

TEST_P(Own, SumsCountEveryCasterButOwnAndCulledOnes) {
    const auto sum = [&](const Glass& glass) { return makeOracle()->ask(glass.question(GetParam()), {}).sums.at(0); };
    Glass glass;
    EXPECT_EQ(sum(glass), glm::uvec3(2 * kOneLayer));
    glass.samples[0].own = 1;
    EXPECT_EQ(sum(glass), glm::uvec3(kOneLayer));
    glass.isCaster = {0, 1};
    EXPECT_EQ(sum(glass), glm::uvec3(0));
    glass = Glass();
    glass.surfaceOf[1] = kOpaque;
    EXPECT_EQ(sum(glass), glm::uvec3(kNoLight));
    EXPECT_EQ(makeOracle()->ask(glass.question(GetParam()), {}).inShadow[0], 1) << "the mask takes every caster for opaque";
    glass.samples[0].position = {0, 0, 0.9375f};
    EXPECT_EQ(sum(glass), glm::uvec3(0)) << "above both";
}

TEST(Refused, SurfacesThatDoNotExist) {
    const auto refused = [](auto&& spoil) {
        Glass glass;
        EXPECT_NO_THROW(makeOracle()->ask(glass.question(kSun), {}));
        spoil(glass);
        EXPECT_THROW(makeOracle()->ask(glass.question(kSun), {}), WorkError);
    };
    refused([](Glass& g) { g.surfaceOf = {0}; });
    refused([](Glass& g) { g.surfaceOf[1] = 2; });
    refused([](Glass& g) { g.surfaces[1].material = 1; });
    refused([](Glass& g) { g.look.materials[0].image = 0; });
    Glass glass;
    OracleQuestion question = glass.question(kSun);
    question.look = nullptr;
    EXPECT_THROW(makeOracle()->ask(question, {}), WorkError);
}

}  // namespace
