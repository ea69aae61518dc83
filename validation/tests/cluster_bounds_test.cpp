// SPDX-License-Identifier: MIT
// clusters/bounds.glsl, compiled as C++, against long double: the range of a plane's side over a box or a cell holds the side at every sample
// inside, up to what the traversal's margin allows for, and is no wider than that.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>

#include "validation/support/glsl_as_cpp.hpp"

#include "glsl/clusters/bounds.glsl"
#include "glsl/clusters/key.glsl"

namespace gno {
namespace {

using Real = long double;
constexpr uint32_t kSeed = 412;

struct Vec {
    Real x, y, z;
    Vec operator+(Vec o) const { return {x + o.x, y + o.y, z + o.z}; }
    Vec operator-(Vec o) const { return {x - o.x, y - o.y, z - o.z}; }
    Vec operator*(Real s) const { return {x * s, y * s, z * s}; }
};
Vec exactly(vec3 v) { return {v.x, v.y, v.z}; }
Vec xyz(vec4 v) { return {v.x, v.y, v.z}; }
Real dotOf(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Real lengthOf(Vec v) { return std::sqrt(dotOf(v, v)); }
Vec crossOf(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
vec4 rounded(Vec v, Real w) { return vec4(float(v.x), float(v.y), float(v.z), float(w)); }

class Random {
public:
    Real real() { return Real(uint32_t(engine_())) * 0x1p-31L - 1; }  ///< -1 .. 1
    int below(int n) { return int(engine_() % uint32_t(n)); }
    Vec inCube() { return {real(), real(), real()}; }
    Vec unit() {
        for (;;) {
            const Vec v = inCube();
            const Real l = lengthOf(v);
            if (l > 0.1L && l < 1) return v * (1 / l);
        }
    }
    vec3 onGrid() { return snap(inCube()); }
    static vec3 snap(Vec v) {
        const auto s = [](Real c) { return std::nearbyint(float(c) * 0x1p40f) * 0x1p-40f; };
        return vec3(s(v.x), s(v.y), s(v.z));
    }

private:
    std::mt19937 engine_{kSeed};
};

vec4 anyLight(Random& random) {
    if (random.below(2) == 0) return vec4(random.onGrid(), 1.0f);
    const Vec d = random.unit();
    return rounded(d * (1 / std::max(std::abs(d.x), std::max(std::abs(d.y), std::abs(d.z)))), 0);
}

/// As volumes have them: xyz at most 1 long; w 0 for a lateral plane of a point light, no larger than the coordinates otherwise.
vec4 anyPlane(Random& random, vec4 light) {
    const Vec n = random.unit() * (1 - 0x1p-20L);
    return rounded(n, light.w != 0.0f && random.below(2) == 0 ? 0 : random.real() * 1.7L);
}

Real sideAt(vec4 plane, vec4 light, vec3 p) { return dotOf(xyz(plane), exactly(p) - xyz(light) * light.w) + plane.w; }

/// What is left of gnoTopMargin for a range's rounding (bounds.glsl): 2E of the scale and of the plane's own offset; directional 4E of the radius.
Real spare(vec4 light, float scale, vec4 plane) {
    return light.w == 0.0f ? 4.0L * GNO_BAND * GNO_SCENE_RADIUS : 2.0L * GNO_BAND * (Real(scale) + std::abs(plane.w));
}

struct Seen {
    Real least = 1e30L, most = -1e30L;
    void add(Real side) { least = std::min(least, side), most = std::max(most, side); }
};

/// The promise that rejects and accepts rest on.
bool holds(vec2 range, Seen seen, Real allowed) { return Real(range.x) - allowed <= seen.least && seen.most <= Real(range.y) + allowed; }

TEST(ClusterBounds, BoxHoldsItsSamplesAndNoMore) {
    Random random;
    int caught = 0, wide = 0;
    for (int round = 0; round < 20000; ++round) {
        const vec4 light = anyLight(random);
        const vec4 plane = anyPlane(random, light);
        const Vec centre = random.inCube();
        const Real size = std::ldexp(1.0L, -random.below(20));
        vec3 low(2.0f), high(-2.0f);
        std::vector<vec3> samples;
        for (int i = 0; i < 6; ++i) {
            samples.push_back(Random::snap(centre * (1 - size) + random.inCube() * size));
            low = min(low, samples.back()), high = max(high, samples.back());
        }
        const GnoClusterBounds box = gnoClusterBox(light, low, high);
        const vec2 range = gnoClusterRange({}, light, box, plane);
        const Real allowed = spare(light, box.scale, plane) + box.uncertain;
        Seen seen, corners;
        for (const vec3 p : samples) {
            seen.add(sideAt(plane, light, p));
            ASSERT_LE(double(light.w != 0.0f ? lengthOf(exactly(p) - xyz(light)) : lengthOf(exactly(p))), box.scale * 1.0000005)
                << "round " << round;
        }
        for (int i = 0; i < 8; ++i) corners.add(sideAt(plane, light, vec3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z)));
        ASSERT_TRUE(holds(range, seen, allowed)) << "seed " << kSeed << " round " << round;
        ASSERT_TRUE(holds(range, corners, allowed)) << "seed " << kSeed << " round " << round;
        ASSERT_NEAR(double(range.x - corners.least), 0, double(allowed)) << "too wide, round " << round;
        ASSERT_NEAR(double(range.y - corners.most), 0, double(allowed)) << "too wide, round " << round;
        if (corners.most - corners.least < 1e-3L) continue;
        ++wide;  // a range that lacks a hundredth does not pass
        const float less = 0.01f * (range.y - range.x);
        caught += !holds({range.x + less, range.y}, corners, allowed) && !holds({range.x, range.y - less}, corners, allowed);
    }
    EXPECT_GT(wide, 5000);
    EXPECT_EQ(caught, wide);
    std::printf("%d of %d shrunken ranges caught\n", caught, wide);
}

/// A viewer anywhere; the basis is orthonormal up to the rounding of its floats, as the host makes it.
GnoClusterFrame anyView(Random& random, Vec& origin) {
    const Vec forward = random.unit();
    Vec right = crossOf(forward, random.unit());
    right = right * (1 / lengthOf(right));
    const Vec down = crossOf(forward, right);
    GnoClusterFrame frame{};
    const vec3 at = Random::snap(random.inCube() * (random.below(3) == 0 ? 4 : 1));
    origin = exactly(at);
    const Real height = 0.05L + std::abs(random.real()), aspect = 0.3L + 2 * std::abs(random.real());
    frame.origin = vec4(at, random.below(4) == 0 ? 0.0f : 1.0f);
    frame.right = rounded(right, height * aspect);
    frame.down = rounded(down, height);
    frame.forward = rounded(forward, 0);
    frame.size = {uint(1 + random.below(300)), uint(1 + random.below(300))};
    return frame;
}

/// A sample of the node, or beside it by what a renderer's rounding may move it, or far beside it.
vec3 sampleNear(Random& random, const GnoClusterFrame& frame, Vec origin, vec2 from, vec2 to, Real depth) {
    const Real s = (random.real() + 1) / 2, t = (random.real() + 1) / 2;
    const Real x = from.x + s * (Real(to.x) - from.x), y = from.y + t * (Real(to.y) - from.y), k = frame.origin.w != 0.0f ? depth : 1;
    const Vec p = origin + xyz(frame.forward) * depth + xyz(frame.right) * (x * k) + xyz(frame.down) * (y * k);
    return Random::snap(p + random.inCube() * (random.below(3) == 0 ? 0 : std::ldexp(1.0L, -6 - random.below(20))));
}

TEST(ClusterBounds, CellHoldsItsSamplesWithinSlackAndNoMore) {
    Random random;
    int samples = 0, outside = 0, caught = 0, wide = 0;
    for (int round = 0; round < 20000; ++round) {
        const vec4 light = anyLight(random);
        const vec4 plane = anyPlane(random, light);
        Vec origin{};
        const GnoClusterFrame frame = anyView(random, origin);
        const GnoClusterLayout tree = gnoClusterLayout(frame.size, random.below(2) == 0 ? GNO_CLUSTER_IMPLICIT : GNO_CLUSTER_FLAT);
        const uint height = gnoClusterTileHeight(tree);
        const uvec2 first(uint(random.below(int(tree.tiles.x))), uint(random.below(int(tree.tiles.y))));
        const uvec2 end = first + uvec2(1u << random.below(3));
        const vec2 from = gnoClusterSlope(frame, {first.x * 8, first.y * height}), to = gnoClusterSlope(frame, {end.x * 8, end.y * height});
        const Real nearest = random.below(8) == 0 ? random.real() : std::ldexp(1.0L, -random.below(12)), deep = std::ldexp(1.0L, -random.below(16));
        Seen seen, depths;
        float slack = 0.0f;
        std::vector<vec3> points;
        for (int i = 0; i < 6; ++i) {
            const vec3 p = sampleNear(random, frame, origin, from, to, nearest + deep * random.real());
            if (std::abs(p.x) > 1 || std::abs(p.y) > 1 || std::abs(p.z) > 1) continue;  // samples lie in the scene
            points.push_back(p);
            depths.add(gnoClusterDepth(frame, p));
            slack = std::max(slack, gnoClusterOutside(frame, p, from, to));
            seen.add(sideAt(plane, light, p));
        }
        if (points.empty()) continue;
        const GnoClusterBounds cell = gnoClusterCell(frame, tree, light, first, end, float(depths.least), float(depths.most), slack);
        const vec2 range = gnoClusterRange(frame, light, cell, plane);
        const Real allowed = spare(light, cell.scale, plane) + cell.uncertain;
        samples += int(points.size());
        ASSERT_TRUE(holds(range, seen, allowed)) << "seed " << kSeed << " round " << round << ": " << double(seen.least) << " .. "
                                                 << double(seen.most) << " not in " << range.x << " .. " << range.y << " +- " << double(allowed);
        for (const vec3 p : points) {
            const Real far = light.w != 0.0f ? lengthOf(exactly(p) - xyz(light)) : lengthOf(exactly(p));
            ASSERT_LE(double(far), cell.scale * 1.0000005) << "seed " << kSeed << " round " << round;
        }
        outside += !holds(range, seen, allowed - slack);
        Seen corners;
        const Vec q = origin - xyz(light) * light.w;
        for (int i = 0; i < 8; ++i) {
            const Real d = i & 4 ? depths.most : depths.least, k = frame.origin.w != 0.0f ? d : 1;
            corners.add(dotOf(xyz(plane), q + xyz(frame.forward) * d + xyz(frame.right) * ((i & 1 ? to.x : from.x) * k) +
                                              xyz(frame.down) * ((i & 2 ? to.y : from.y) * k)) +
                        plane.w);
        }
        const Real widened = 4e-5L * (1 + std::max(std::abs(depths.least), std::abs(depths.most)));  // 2^-16 of the depth, and its slopes
        const Real wider = allowed + widened * (1 + std::abs(from.x) + std::abs(to.x) + std::abs(from.y) + std::abs(to.y));
        ASSERT_TRUE(holds(range, corners, allowed)) << "seed " << kSeed << " round " << round;
        ASSERT_NEAR(double(range.x - corners.least), 0, double(wider)) << "too wide, round " << round;
        ASSERT_NEAR(double(range.y - corners.most), 0, double(wider)) << "too wide, round " << round;
        const float less = 0.1f * (range.y - range.x);
        if (less < 4 * wider) continue;
        ++wide;
        caught += !holds({range.x + less, range.y}, corners, allowed) && !holds({range.x, range.y - less}, corners, allowed);
    }
    EXPECT_GT(samples, 20000);
    EXPECT_GT(outside, 100) << "slack is what holds some of them";
    EXPECT_GT(wide, 1000);
    EXPECT_EQ(caught, wide);
    std::printf("%d samples, %d cells hold theirs by slack only; %d of %d shrunken ranges caught\n", samples, outside, caught, wide);
}

}  // namespace
}  // namespace gno
