// SPDX-License-Identifier: MIT
// top/plane.glsl, compiled as C++: no point of a shadow volume lies outside the bounds of its side of a plane (9). Planes, casters and points as a
// tree meets them: random ones, casters that share an edge with the plane's owner or stand an ulp off its plane, directions and points, in every
// float mode.
#include <gtest/gtest.h>

#include <cstdio>

#include "validation/mutants/scene_parts.hpp"
#include "validation/support/exact_reference.hpp"
#include "validation/support/glsl_as_cpp.hpp"

#include "glsl/top/plane.glsl"

namespace gno {
namespace {

using mutants::behind;
using mutants::onCaster;
using questions::Random;
using questions::snap;

constexpr uint kSeed = 905;

vec4 anyLight(Random& r) {
    if (r.below(2) == 0) return vec4(r.uniform(), 1.0f);
    return mutants::directional(glm::dvec3(r.real(), r.real(), r.real()) + 0.01);
}

/// A caster beside an owner: anywhere, small and far from it, sharing its edge ab, or with a vertex hardly off the plane through ab and the light.
GnoCaster neighbourOf(Random& r, vec4 light, const GnoCaster& owner) {
    const glm::dvec3 middle(r.real(), r.real(), r.real());
    const auto near = [&](double size) { return snap(middle * 0.9 + size * glm::dvec3(r.real(), r.real(), r.real())); };
    switch (r.below(4)) {
        case 0:
            return {r.uniform(), r.uniform(), r.uniform()};
        case 1: {
            const double size = std::ldexp(0.1, -r.below(12));
            return {near(size), near(size), near(size)};
        }
        case 2:
            return {owner.b, owner.a, r.uniform()};
        default: {
            const auto onPlane = [&] {
                return behind(light, glm::dvec3(owner.a) + (glm::dvec3(owner.b) - glm::dvec3(owner.a)) * (r.real() * 0.5 + 0.5),
                              1.0 + 0.4 * r.real());
            };
            return {r.neighbour(snap(onPlane())), snap(onPlane() + std::ldexp(1.0, -10 - r.below(12)) * glm::dvec3(r.real(), r.real(), r.real())),
                    r.uniform()};
        }
    }
}

struct Count {
    uint positive = 0, negative = 0, points = 0, lowered = 0;
};

void check(Random& r, vec4 light, const GnoCaster& owner, const GnoCaster& t, Count& count) {
    const int facing = exact::orient3dLight(light, exact::fixed(owner.a), exact::fixed(owner.b), exact::fixed(owner.c));
    if (facing == 0) return;
    const vec4 plane = gnoTopLateralPlane(light, owner.a, owner.b, facing, GNO_PRECISION_CERTIFIED);
    const vec3 q[3] = {gnoFromLight(light, t.a), gnoFromLight(light, t.b), gnoFromLight(light, t.c)};
    const vec3 v[3] = {t.a, t.b, t.c};
    float sides[3], scales[3];
    bool above = true, below = true;
    for (int i = 0; i < 3; ++i) {  // as gnoTopInsert files it
        scales[i] = gnoLightScale(light, q[i]);
        sides[i] = gnoTopSide(plane, q[i]);
        const bool touches = v[i] == owner.a || v[i] == owner.b;
        if (touches) sides[i] = 0.0f;
        above = above && (touches || sides[i] > gnoTopMargin(light, false, scales[i], 0.0f));
        below = below && (touches || sides[i] < -gnoTopMargin(light, false, scales[i], 0.0f));
    }
    if (!above && !below) return;
    const vec3 side(sides[0], sides[1], sides[2]), scale(scales[0], scales[1], scales[2]);
    const float depth = gnoTopLeastDepth(light, t), spread = gnoTopSpread(light, q[0], q[1], q[2]);
    const uint positive = above ? gnoTopPositive(light, side, scale, depth, spread) : 0u;
    const float negative = below ? gnoTopNegative(light, side, scale, depth, spread) : 0.0f;
    count.positive += above;
    count.negative += below;
    count.lowered += above && (positive & 0xFFFFu) != 0xFFFFu;
    for (int i = 0; i < 12; ++i) {
        const double k = r.below(3) == 0 ? 1.0 + std::ldexp(1.0, -r.below(24)) : 1.0 + 1.5 * (r.real() + 1.0);
        const vec3 p = snap(behind(light, onCaster(r, t), k));
        if (!mutants::inScene(p) || !exact::inShadowOf(light, exact::fixed(t.a), exact::fixed(t.b), exact::fixed(t.c), exact::fixed(p))) continue;
        ++count.points;
        const vec3 from = gnoFromLight(light, p);
        const float at = gnoTopSide(plane, from), length = gnoLightScale(light, from);
        if (above) {
            ASSERT_TRUE(gnoTopInPositive(positive, at, length)) << "side " << at << ", scale " << length << ", bounds " << std::hex << positive;
        }
        if (below) {
            ASSERT_LE(-at, negative * length);
        }
    }
}

TEST(TopSlab, HoldsEveryPointOfAVolume) {
    for (const uint mode : {0u, 1u, 2u, 3u, 4u}) {
        SCOPED_TRACE(mode);
        Random r(kSeed);
        Count count;
        const cpu::FloatMode floats(mode);
        for (int round = 0; round < 20000 && !HasFatalFailure(); ++round) {
            const vec4 light = anyLight(r);
            const GnoCaster owner{r.uniform(), r.uniform(), r.uniform()};
            check(r, light, owner, neighbourOf(r, light, owner), count);
        }
        std::printf("seed %u, float mode %u: %u positive (%u with a lower bound), %u negative, %u points\n", kSeed, mode, count.positive,
                    count.lowered, count.negative, count.points);
        EXPECT_GT(count.lowered, 500u);
        EXPECT_GT(count.negative, 500u);
        EXPECT_GT(count.points, 10000u);
    }
}

// It is no wider than it has to be: a small caster's bounds lie within 2 % of each other's sine (a half has 8 bits).
TEST(TopSlab, IsNarrowForASmallCaster) {
    const vec4 light(0, 0, 0, 1), plane(1, 0, 0, 0);
    const vec3 q[3] = {vec3(0.5f, 0.5f, 0), vec3(0.5009765625f, 0.5f, 0), vec3(0.5f, 0.5f, 0.0009765625f)};
    const vec3 sides(q[0].x, q[1].x, q[2].x), scales(gnoLength(q[0]), gnoLength(q[1]), gnoLength(q[2]));
    const uint positive = gnoTopPositive(light, sides, scales, gnoTopLeastDepth(light, {q[0], q[1], q[2]}), gnoTopSpread(light, q[0], q[1], q[2]));
    EXPECT_TRUE(gnoTopInPositive(positive, 0.7071f, 1.0f));
    EXPECT_FALSE(gnoTopInPositive(positive, 0.695f, 1.0f));
    EXPECT_FALSE(gnoTopInPositive(positive, 0.72f, 1.0f));
    EXPECT_FALSE(gnoTopInPositive(0u, 0.5f, 1.0f));  // nothing there at all
}

}  // namespace
}  // namespace gno
