// SPDX-License-Identifier: MIT
// The TOP tree that a device built, read back: every caster that casts is in it once or lies inside another's volume, links and bounds are what the
// queries rely on. For any number of casters, work group size and insertion order.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "validation/support/device_test.hpp"
#include "validation/tests/oracle_cases.hpp"
#include "validation/tests/top_structure.hpp"

namespace gno {
namespace {

using host::Precision;
using host::cases::Random;

constexpr uint32_t kSeed = 41;
const glm::vec4 kPoint(0.125f, 0.75f, -0.25f, 1), kDirection(0.25f, 1, -0.125f, 0);

struct Casters {
    std::vector<host::Triangle> triangles;
    std::vector<uint8_t> closed;
    host::Cull cull = host::Cull::none;
};

/// Small triangles all over the cube; `size` is the half extent of one.
Casters soup(size_t count, double size) {
    Random random(kSeed);
    Casters casters;
    while (casters.triangles.size() < count) {
        const glm::dvec3 at = random.inCube(1 - size);
        const auto corner = [&] { return host::cases::snap(at + random.inCube(size)); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        casters.triangles.push_back({a, b, c});
    }
    return casters;
}

/// By the definition, in integers: casts, and is not left out by front-face culling.
std::vector<uint8_t> castersByDefinition(const Casters& casters, glm::vec4 light) {
    std::vector<uint8_t> kept;
    for (size_t i = 0; i < casters.triangles.size(); ++i) {
        const host::Triangle& t = casters.triangles[i];
        const int facing = exact::orient3dLight(light, exact::fixed(t.a), exact::fixed(t.b), exact::fixed(t.c));
        const bool front = casters.cull == host::Cull::front && !casters.closed.empty() && casters.closed[i] && facing < 0;
        kept.push_back(facing != 0 && !front);
    }
    return kept;
}

/// The volume of `inner` is a part of the volume of `outer`: each vertex is in its closed cone, and on its plane or behind it.
bool isInside(const host::Triangle& inner, const host::Triangle& outer, glm::vec4 light) {
    using exact::operator-;
    const auto a = exact::fixed(outer.a), b = exact::fixed(outer.b), c = exact::fixed(outer.c), l = exact::fixed(glm::vec3(light));
    const int facing = exact::orient3dLight(light, a, b, c),
              front = light.w != 0 ? exact::orient3d(a, b, c, l) : exact::sign(exact::det(b - a, c - a, l));
    for (const glm::vec3 v : {inner.a, inner.b, inner.c}) {
        const auto p = exact::fixed(v);
        for (const int side : {exact::orient3dLight(light, a, b, p), exact::orient3dLight(light, b, c, p), exact::orient3dLight(light, c, a, p)})
            if (side == -facing) return false;
        if (exact::orient3d(a, b, c, p) == front) return false;
    }
    return true;
}

/// Builds and checks one tree; returns how many casters stand in it.
size_t expectSound(const Casters& casters, glm::vec4 light, Precision precision, uint32_t group, uint32_t seed) {
    SCOPED_TRACE(fmt::format("{} casters, {}, {}, group {}, seed {}", casters.triangles.size(), light.w == 0 ? "directional" : "point",
                             name(precision), group, seed));
    const size_t count = casters.triangles.size();
    host::Frame frame;
    frame.triangles = casters.triangles;
    frame.closed = casters.closed.empty() ? std::vector<uint8_t>(count, 0) : casters.closed;
    const std::array samples{host::OracleSample{{0, 0, 0}, host::kNoCaster}};
    host::FrameInputs inputs(test::passes(), frame, samples);
    inputs.setLight(light, casters.cull);
    const auto tree = host::built<host::TopTree>(inputs, TopOptions{.precision = uint32_t(precision), .seed = seed, .groupSize = group});

    const std::vector<uint8_t> kept = castersByDefinition(casters, light);
    const uint64_t casting = uint64_t(std::count(kept.begin(), kept.end(), 1));
    EXPECT_EQ(inputs.casterCount(), casting);
    EXPECT_EQ(tree.counters().inserted + tree.counters().dropped, casting);
    EXPECT_EQ(tree.planes().bytes() + tree.links().bytes(), 128 * std::max<size_t>(count, 1));

    const test::TopBuffers buffers = test::download(tree);
    const test::TopWalk walked = walk(buffers, kept);
    EXPECT_EQ(walked.error, "");
    if (!walked.error.empty()) return 0;
    EXPECT_EQ(walked.order.empty(), casting == 0);

    const bool published = precision == Precision::published;
    EXPECT_EQ(checkBounds(buffers, walked, casters.triangles, light, !published, published ? 1e-4 : 0.0), "");

    std::mt19937 random(seed);  // a dropped caster lies inside another; at most 300 of them are looked at, the margins make it certain
    std::vector<uint32_t> dropped;
    for (uint32_t i = 0; i < count; ++i)
        if (kept[i] && !walked.reached[i]) dropped.push_back(i);
    std::shuffle(dropped.begin(), dropped.end(), random);
    if (published) dropped.clear();  // fp32 signs only
    for (size_t i = 0; i < std::min<size_t>(dropped.size(), 300); ++i) {
        const bool inside = std::any_of(walked.order.begin(), walked.order.end(),
                                        [&](uint32_t o) { return isInside(casters.triangles[dropped[i]], casters.triangles[o], light); });
        EXPECT_TRUE(inside) << "caster " << dropped[i] << " is neither in the tree nor inside the volume of one that is";
        if (!inside) break;
    }
    return walked.order.size();
}

TEST(TopBuild, WorkGroupSizes) {
    const Casters casters = soup(1000, 0.05);
    for (const uint32_t group : {1u, 32u, 64u, 100u, 256u})
        for (const glm::vec4 light : {kPoint, kDirection}) expectSound(casters, light, Precision::certified, group, group + 7);
    expectSound(casters, kPoint, Precision::published, 100, 3);
}

TEST(TopBuild, InsertionOrders) {
    const Casters casters = soup(1000, 0.05);
    for (const auto precision : {Precision::published, Precision::conservative, Precision::certified})
        for (const uint32_t seed : {0u, 1u, 4294967295u}) expectSound(casters, kPoint, precision, 64, seed);
}

TEST(TopBuild, FewCasters) {
    for (const size_t count : {0u, 1u, 2u, 3u, 63u, 64u, 65u})
        for (const glm::vec4 light : {kPoint, kDirection})
            for (const auto precision : {Precision::published, Precision::certified}) {
                const size_t in = expectSound(soup(count, 0.05), light, precision, 64, 1);
                if (count < 3) {
                    EXPECT_EQ(in, count);
                }
            }
}

TEST(TopBuild, ManyCasters) {
    const Casters casters = soup(20000, 0.02);
    EXPECT_GT(expectSound(casters, kPoint, Precision::certified, 64, 1), 1000u);
    EXPECT_GT(expectSound(casters, kPoint, Precision::published, 64, 1), 1000u);
    EXPECT_GT(expectSound(casters, kDirection, Precision::certified, 64, 2), 1000u);
}

TEST(TopBuild, HugeCastersNextToTheLight) {
    for (const auto precision : {Precision::published, Precision::conservative, Precision::certified}) {
        expectSound(soup(200, 0.9), kPoint, precision, 64, 1);
        expectSound(soup(200, 0.9), kDirection, precision, 64, 1);
    }
}

TEST(TopBuild, HardCases) {
    for (const host::cases::HardCase& hard : host::cases::hardCases(kSeed, 0)) {
        SCOPED_TRACE(hard.name);
        expectSound({hard.triangles, {}}, hard.light, Precision::certified, 64, 5);
    }
}

TEST(TopBuild, AllCulled) {
    Casters casters = soup(300, 0.1);
    for (host::Triangle& t : casters.triangles)  // turned to the light, which sees the front of each
        if (exact::orient3dLight(kPoint, exact::fixed(t.a), exact::fixed(t.b), exact::fixed(t.c)) > 0) std::swap(t.b, t.c);
    casters.closed.assign(casters.triangles.size(), 1);
    casters.cull = host::Cull::front;
    EXPECT_EQ(expectSound(casters, kPoint, Precision::certified, 64, 1), 0u);
    casters.closed[17] = 0;
    EXPECT_EQ(expectSound(casters, kPoint, Precision::certified, 64, 1), 1u);
}

TEST(TopBuild, SomeCulledAndSomeEdgeOn) {
    Casters casters = soup(600, 0.1);
    for (size_t i = 0; i < casters.triangles.size(); i += 3) casters.triangles[i].c = glm::vec3(kPoint);  // its plane goes through the light
    casters.closed.assign(casters.triangles.size(), 0);
    for (size_t i = 0; i < casters.triangles.size(); i += 2) casters.closed[i] = 1;
    casters.cull = host::Cull::front;
    const size_t in = expectSound(casters, kPoint, Precision::certified, 64, 1);
    EXPECT_GT(in, 0u);
    EXPECT_LT(in, 401u);
}

TEST(TopBuild, AllEdgeOn) {
    Casters point = soup(300, 0.2), direction = point;
    for (host::Triangle& t : point.triangles) t.c = glm::vec3(kPoint);
    EXPECT_EQ(expectSound(point, kPoint, Precision::certified, 64, 1), 0u);
    EXPECT_EQ(expectSound(point, kPoint, Precision::published, 64, 1), 0u);
    for (host::Triangle& t : direction.triangles) t.c = t.a + glm::vec3(kDirection) * 0.0625f;
    Casters onGrid;
    for (const host::Triangle& t : direction.triangles)  // where the sum was exact
        if (exact::orient3dLight(kDirection, exact::fixed(t.a), exact::fixed(t.b), exact::fixed(t.c)) == 0) onGrid.triangles.push_back(t);
    ASSERT_GT(onGrid.triangles.size(), 20u);
    EXPECT_EQ(expectSound(onGrid, kDirection, Precision::certified, 64, 1), 0u);
}

TEST(TopBuild, ThousandCopies) {
    for (const glm::vec4 light : {kPoint, kDirection})
        for (const auto precision : {Precision::published, Precision::certified}) {
            Casters casters = soup(1, 0.3);
            casters.triangles.resize(1000, casters.triangles.front());
            expectSound(casters, light, precision, 64, 1);
        }
}

// The checks above can fail: each line damages a sound tree in one way.
TEST(TopBuild, ChecksSeeDamage) {
    const Casters casters = soup(400, 0.2);
    host::Frame frame;
    frame.triangles = casters.triangles;
    frame.closed.assign(casters.triangles.size(), 0);
    const std::array samples{host::OracleSample{{0, 0, 0}, host::kNoCaster}};
    host::FrameInputs inputs(test::passes(), frame, samples);
    inputs.setLight(kPoint, host::Cull::none);
    const std::vector<uint8_t> kept = castersByDefinition(casters, kPoint);
    const test::TopBuffers sound = test::download(host::built<host::TopTree>(inputs, TopOptions{}));
    const test::TopWalk walked = walk(sound, kept);
    ASSERT_EQ(walked.error, "");
    ASSERT_EQ(checkBounds(sound, walked, casters.triangles, kPoint, true, 0), "");
    uint32_t inside = GNO_TOP_NONE;  // a caster below a lateral node's intersection child
    for (const uint32_t caster : walked.order)
        if (walked.ancestor[caster] != GNO_TOP_NONE && walked.ancestor[caster] % 4 != 3 && walked.parent[caster] == walked.ancestor[caster])
            inside = caster;
    ASSERT_NE(inside, GNO_TOP_NONE);

    test::TopBuffers cut = sound;  // the caster is lost: its children too
    cut.links[walked.ancestor[inside]].intersectionChild = GNO_TOP_NONE;
    EXPECT_FALSE(walk(cut, kept).reached[inside]);
    test::TopBuffers twice = sound;
    twice.links[4 * inside + 3].positiveChild = twice.header.root;
    EXPECT_NE(walk(twice, kept).error, "");
    test::TopBuffers stranger = sound;
    stranger.links[4 * inside + 1].aux = 4 * walked.order.front() + 3;
    EXPECT_NE(walk(stranger, kept).error, "");
    std::vector<uint8_t> other = kept;
    other[inside] = 0;
    EXPECT_NE(walk(sound, other).error, "");
    test::TopBuffers narrow = sound;
    narrow.links[walked.ancestor[inside]].wedge = 0;
    EXPECT_NE(checkBounds(narrow, walked, casters.triangles, kPoint, true, 0), "");
    test::TopBuffers deep = sound;
    deep.links[walked.parent[inside] / 4 * 4].aux = std::bit_cast<uint32_t>(3.0f);
    EXPECT_NE(checkBounds(deep, walked, casters.triangles, kPoint, true, 0), "");
}

}  // namespace
}  // namespace gno
