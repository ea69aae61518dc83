// SPDX-License-Identifier: MIT
// Changes of a scene that cannot change the answer do not change the mask of any certified technique. No oracle here: a second witness of the
// definition.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "validation/hard_cases/scene_maker.hpp"
#include "validation/support/exact_reference.hpp"

namespace gno::hard {
namespace {

using Mask = std::vector<uint32_t>;

/// The mask of the first certified technique; all others must agree.
Mask maskOf(const test::Scene& scene) {
    std::vector<std::string> names;
    for (const auto& technique : host::techniques()) {
        const auto& rungs = technique->info().precisions;
        if (std::find(rungs.begin(), rungs.end(), host::Precision::certified) != rungs.end()) names.push_back(technique->info().name);
    }
    const auto results = test::runAll(scene, names, host::Precision::certified);
    for (size_t i = 1; i < results.size(); ++i) EXPECT_EQ(results[i].visibility, results[0].visibility) << names[i] << " against " << names[0];
    return results.at(0).visibility;
}

/// v to a multiple of 2^-20: sums and halves of such numbers are exact.
glm::vec3 coarse(glm::dvec3 v) {
    const auto one = [](double x) { return float(std::ldexp(std::nearbyint(std::ldexp(x, 20)), -20)); };
    return {one(v.x), one(v.y), one(v.z)};
}

bool onLightsSide(const Triangle& t, glm::vec4 light, glm::vec3 p) {
    const exact::Vec a = exact::fixed(t.a), b = exact::fixed(t.b), c = exact::fixed(t.c);
    const int facing = exact::orient3dLight(light, a, b, c);  // orient3d(a, b, c, light) is its opposite
    return facing != 0 && exact::orient3d(a, b, c, exact::fixed(p)) == -facing;
}

/// Casters and samples within 1/4 of the origin, all numbers multiples of 2^-20; every third sample lies on a caster (a little before it).
test::Scene baseScene(uint32_t seed, bool directional) {
    Random random(seed);
    test::Scene scene;
    scene.light = directional ? directionalLight({0.25, 1, -0.375}) : glm::vec4(coarse({0.0625, 0.24, -0.03}), 1);
    addQuad(scene.triangles, {-0.25f, -0.125f, -0.25f}, {-0.25f, -0.125f, 0.25f}, {0.25f, -0.125f, 0.25f}, {0.25f, -0.125f, -0.25f});
    addBall(scene.triangles, {0.05, 0, 0.03}, 0.06, 8, 6);
    for (int i = 0; i < 6; ++i) {
        const glm::vec3 low = random.lattice(16) * 0.125f;
        addBox(scene.triangles, low, low + 0x1p-5f);
    }
    for (int i = 0; i < 120; ++i) {
        const glm::dvec3 at = random.inCube(0.15);
        const auto corner = [&] { return glm::vec3(at + random.inCube(0.05)); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        scene.triangles.push_back({a, b, c});
    }
    for (Triangle& t : scene.triangles) t = {coarse(t.a), coarse(t.b), coarse(t.c)};
    while (scene.samples.size() < 1500) {
        const uint32_t own = random.below(uint32_t(scene.triangles.size()));
        const Triangle& t = scene.triangles[own];
        const glm::dvec3 q = pointOf(t, random);
        if (scene.samples.size() % 3 == 0) {
            const glm::dvec3 n = glm::cross(glm::dvec3(t.b - t.a), glm::dvec3(t.c - t.a));
            const glm::vec3 p = coarse(q + (random.below(2) ? 1e-4 : -1e-4) * n / (glm::length(n) + 1e-12));
            if (onLightsSide(t, scene.light, p)) scene.samples.push_back({p, own});
        } else {
            const double step = random.below(3) ? random.real(0, 0.5) : double(random.below(3)) * 0.5;
            const glm::vec3 p = coarse(scene.samples.size() % 3 == 1 ? behind(scene.light, q, step) : random.inCube(0.25));
            if (glm::all(glm::lessThanEqual(glm::abs(p), glm::vec3(0.25f)))) scene.samples.push_back({p, host::kNoCaster});
        }
    }
    return scene;
}

/// Every position through `map`, a point light included; a direction is the caller's to map.
template <class Map>
test::Scene mapped(test::Scene scene, const Map& map, bool flip) {
    for (Triangle& t : scene.triangles) {
        t = {map(t.a), map(t.b), map(t.c)};
        if (flip) std::swap(t.b, t.c);
    }
    for (host::OracleSample& s : scene.samples) s.position = map(s.position);
    if (scene.light.w != 0) scene.light = {map(glm::vec3(scene.light)), 1};
    return scene;
}

void expectSome(const Mask& mask) {  // a mask of one colour would prove nothing
    const auto dark = std::count(mask.begin(), mask.end(), GNO_VISIBILITY_SHADOW);
    EXPECT_GT(dark, std::ptrdiff_t(mask.size() / 10));
    EXPECT_LT(dark, std::ptrdiff_t(mask.size() - mask.size() / 10));
}

class Metamorphic : public testing::TestWithParam<bool> {
protected:
    const test::Scene base = baseScene(7, GetParam());
    Mask before = maskOf(base);
    void SetUp() override { expectSome(before); }
};

TEST_P(Metamorphic, OrderOfCasters) {
    test::Scene scene = base;
    std::vector<uint32_t> to(base.triangles.size());
    std::iota(to.begin(), to.end(), 0u);
    Random random(3);
    for (size_t i = to.size(); i > 1; --i) std::swap(to[i - 1], to[random.below(uint32_t(i))]);
    for (size_t i = 0; i < to.size(); ++i) scene.triangles[to[i]] = base.triangles[i];
    for (host::OracleSample& s : scene.samples)
        if (s.own != host::kNoCaster) s.own = to[s.own];
    EXPECT_EQ(maskOf(scene), before);
}

TEST_P(Metamorphic, OrderOfVertices) {
    test::Scene scene = base;
    for (size_t i = 0; i < scene.triangles.size(); ++i) {
        const Triangle t = scene.triangles[i];
        scene.triangles[i] = i % 3 == 0 ? Triangle{t.b, t.c, t.a} : i % 3 == 1 ? Triangle{t.c, t.b, t.a} : t;
    }
    EXPECT_EQ(maskOf(scene), before);
}

TEST_P(Metamorphic, SplitAtMidpoints) {  // free samples only: own would leave out one piece instead of the whole
    test::Scene whole = base;
    for (host::OracleSample& s : whole.samples) s.own = host::kNoCaster;
    test::Scene pieces = whole;
    pieces.triangles.clear();
    for (size_t i = 0; i < whole.triangles.size(); ++i) {
        const auto& [a, b, c] = whole.triangles[i];
        const glm::vec3 ab = 0.5f * (a + b), bc = 0.5f * (b + c), ca = 0.5f * (c + a);  // exact
        if (i % 3 == 0) {
            pieces.triangles.insert(pieces.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        } else if (i % 3 == 1) {  // T-junctions with the neighbours
            pieces.triangles.insert(pieces.triangles.end(), {{a, ab, c}, {ab, b, c}});
        } else {
            pieces.triangles.push_back(whole.triangles[i]);
        }
    }
    EXPECT_EQ(maskOf(pieces), maskOf(whole));
}

TEST_P(Metamorphic, PowerOfTwoScale) {
    for (const float factor : {0.5f, 0x1p-8f, 2.0f, 4.0f}) {
        SCOPED_TRACE(factor);
        EXPECT_EQ(maskOf(mapped(
                      base, [&](glm::vec3 p) { return p * factor; }, false)),
                  before);
    }
}

TEST_P(Metamorphic, Translation) {
    for (const glm::vec3 by : {glm::vec3(0.75f, -0.5f, 0.625f), glm::vec3(-0.75f), glm::vec3(0, 0x1p-20f, -0x1p-18f)}) {
        EXPECT_EQ(maskOf(mapped(
                      base, [&](glm::vec3 p) { return p + by; }, false)),
                  before);
    }
}

TEST_P(Metamorphic, AxesAndReflections) {
    const auto check = [&](const auto& map, bool flip) {
        test::Scene scene = mapped(base, map, flip);
        if (scene.light.w == 0) scene.light = {map(glm::vec3(base.light)), 0};
        EXPECT_EQ(maskOf(scene), before);
    };
    check([](glm::vec3 p) { return glm::vec3(p.y, p.z, p.x); }, false);
    check([](glm::vec3 p) { return glm::vec3(p.y, p.x, p.z); }, true);
    check([](glm::vec3 p) { return glm::vec3(-p.x, p.y, p.z); }, true);
    check([](glm::vec3 p) { return glm::vec3(-p.z, -p.y, -p.x); }, false);
}

TEST_P(Metamorphic, WindingFlipsWithTheReflection) {  // front-face culling looks at it
    test::Scene scene = base;
    scene.triangles.resize(2 + 80);  // ground and ball
    scene.closed.assign(scene.triangles.size(), 1);
    scene.cull = host::Cull::front;
    for (host::OracleSample& s : scene.samples) s.own = host::kNoCaster;
    const Mask culled = maskOf(scene);
    const auto reflect = [](glm::vec3 p) { return glm::vec3(p.x, p.y, -p.z); };
    test::Scene flipped = mapped(scene, reflect, true), notFlipped = mapped(scene, reflect, false);
    for (test::Scene* s : {&flipped, &notFlipped})
        if (s->light.w == 0) s->light = {reflect(glm::vec3(scene.light)), 0};
    EXPECT_EQ(maskOf(flipped), culled);
    EXPECT_NE(maskOf(notFlipped), culled);  // the comparison can fail
}

TEST_P(Metamorphic, RepeatedCasters) {
    test::Scene scene = base;
    scene.triangles.insert(scene.triangles.end(), base.triangles.begin(), base.triangles.end());
    for (size_t i = 0; i < 60; ++i) scene.triangles.push_back({base.triangles[i].c, base.triangles[i].b, base.triangles[i].a});
    EXPECT_EQ(maskOf(scene), before);
}

TEST_P(Metamorphic, CastersBehindAllSamples) {
    test::Scene scene = base;
    Random random(11);
    for (int i = 0; i < 300; ++i) {  // below y = -1/4, light and samples above
        const auto corner = [&] { return coarse({random.real(-0.9, 0.9), random.real(-0.6, -0.26), random.real(-0.9, 0.9)}); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        scene.triangles.push_back({a, b, c});
    }
    EXPECT_EQ(maskOf(scene), before);
}

TEST_P(Metamorphic, MoreCastersOnlyDarken) {
    test::Scene scene = base;
    scene.triangles.resize(100);
    for (host::OracleSample& s : scene.samples)
        if (s.own >= 100) s.own = host::kNoCaster;
    const Mask few = maskOf(scene);
    for (size_t i = 100; i < base.triangles.size(); ++i) scene.triangles.push_back(base.triangles[i]);
    const Mask all = maskOf(scene);
    EXPECT_NE(all, few);
    for (size_t i = 0; i < all.size(); ++i) EXPECT_LE(all[i], few[i]) << "sample " << i << " became lit";
}

TEST_P(Metamorphic, OneMovedCasterIsSeen) {  // the comparisons above can fail
    test::Scene scene = base;
    for (size_t i = 0; i < 2; ++i)
        scene.triangles[i] = {scene.triangles[i].a + 0.125f, scene.triangles[i].b + 0.125f, scene.triangles[i].c + 0.125f};
    for (host::OracleSample& sample : scene.samples)
        if (sample.own < 2) sample.own = host::kNoCaster;  // they lie on them no more: an own caster has its samples on the light's side
    EXPECT_NE(maskOf(scene), before);
}

std::string lightName(const testing::TestParamInfo<bool>& light) { return light.param ? "Directional" : "Point"; }

INSTANTIATE_TEST_SUITE_P(Lights, Metamorphic, testing::Bool(), lightName);

}  // namespace
}  // namespace gno::hard
