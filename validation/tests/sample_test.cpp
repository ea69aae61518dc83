// SPDX-License-Identifier: MIT
// core/sample.glsl, compiled as C++: snapping is the host's, and a view sample lies off its own caster's plane, whatever the rasteriser did to it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "host_min/scene/grid.hpp"
#include "validation/support/exact_reference.hpp"
#include "validation/support/glsl_as_cpp.hpp"
#include "validation/support/grid_questions.hpp"

namespace gno {
#include "glsl/core/orient3d.glsl"
}
#include "glsl/core/sample.glsl"

namespace gno {
namespace {

using questions::Random;
using questions::show;

uint32_t bits(float x) { return std::bit_cast<uint32_t>(x); }

/// Floats of every size that a position can have, with the places where rounding is hard among them.
std::vector<float> coordinates() {
    std::vector<float> all{0.0f, -0.0f, 0x1p-126f, 0x1p-149f, 0x1.fffffep-127f};
    std::mt19937_64 random(40);
    const auto unit = [&] { return double(random() >> 11) * 0x1p-53; };
    for (int i = 0; i < 200000; ++i) all.push_back(float(std::ldexp(2 * unit() - 1, -int(random() % 48))));
    for (int i = 0; i < 200000; ++i) all.push_back(float((2 * unit() - 1) * 0x1p-16));                     // where grid and fp32 steps meet
    for (int i = 0; i < 20000; ++i) all.push_back(float(std::ldexp(0.5 + double(random() % 4096), -40)));  // half-way between two grid points
    for (int i = 0; i < 20000; ++i) all.push_back(std::nextafter(float(std::ldexp(0.5 + double(random() % 4096), -40)), unit() < 0.5 ? 0.0f : 1.0f));
    for (int exponent = -45; exponent <= 0; ++exponent)
        for (const float x :
             {std::ldexp(1.0f, exponent), std::nextafter(std::ldexp(1.0f, exponent), 0.0f), std::nextafter(std::ldexp(1.0f, exponent), 2.0f)})
            all.push_back(x);
    const size_t positive = all.size();
    for (size_t i = 0; i < positive; ++i) all.push_back(-all[i]);
    return all;
}

TEST(SnapToGrid, IsTheHostsToTheBit) {
    for (const float x : coordinates()) {
        const float want = host::snapCoordinate(double(x));
        ASSERT_EQ(bits(gnoSnapToGrid(vec3(x, 0, 0)).x), bits(want)) << std::hexfloat << x;
        ASSERT_EQ(bits(gnoSnapToGrid(vec3(0, x, 0)).y), bits(want)) << std::hexfloat << x;
        ASSERT_EQ(bits(gnoSnapToGrid(vec3(0, 0, x)).z), bits(want)) << std::hexfloat << x;
    }
}

TEST(SnapToGrid, LeavesGridPointsAlone) {
    for (const float x : coordinates()) {
        const float once = gnoSnapToGrid(vec3(x)).x;
        ASSERT_EQ(bits(gnoSnapToGrid(vec3(once)).x), bits(once)) << std::hexfloat << x;
        const double units = std::ldexp(double(once), 40);
        ASSERT_EQ(units, std::nearbyint(units)) << std::hexfloat << x;
    }
    for (int64_t unit = 0; unit < (int64_t{1} << 24); unit += 1 + unit / 4096) {
        const float x = float(std::ldexp(double(unit), -40));
        ASSERT_EQ(bits(gnoSnapToGrid(vec3(x)).x), bits(x)) << unit;
        ASSERT_EQ(gnoSnapToGrid(vec3(-x)).x, -x) << unit;
    }
}

struct Shape {
    const char* name;
    GnoCaster (*make)(Random&);
};
void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }

GnoCaster around(Random& r, glm::dvec3 centre, double size) {
    const auto corner = [&] { return questions::snap(centre + size * glm::dvec3(r.real(), r.real(), r.real())); };
    return {corner(), corner(), corner()};
}

const Shape kShapes[] = {
    {"Random",
     [](Random& r) -> GnoCaster {
         return {r.uniform(), r.uniform(), r.uniform()};
     }},
    {"Small", [](Random& r) { return around(r, glm::dvec3(r.uniform(0.9)), 1e-3); }},
    {"Tiny", [](Random& r) { return around(r, glm::dvec3(r.uniform(0.9)), 0x1p-21); }},
    {"TinyAtTheOrigin", [](Random& r) { return around(r, glm::dvec3(0), 0x1p-34); }},
    {"Huge",
     [](Random& r) -> GnoCaster {
         const auto corner = [&] { return vec3(r.below(2) == 0 ? 1.0f : -1.0f, r.below(2) == 0 ? 1.0f : -1.0f, r.uniform().z); };
         return {corner(), corner(), corner()};
     }},
    {"Sliver",
     [](Random& r) -> GnoCaster {
         const vec3 a = r.uniform(), b = r.uniform();
         return {a, b, r.nudge(glm::dvec3(a) + (glm::dvec3(b) - glm::dvec3(a)) * r.real())};
     }},
    {"AxisAligned",
     [](Random& r) -> GnoCaster {
         const float z = r.uniform().z;
         const auto corner = [&] { return vec3(r.uniform().x, r.uniform().y, z); };
         return {corner(), corner(), corner()};
     }},
    {"AnyExponent",
     [](Random& r) -> GnoCaster {
         const auto corner = [&] { return glm::clamp(r.anyExponent(), -1.0f, 1.0f); };
         return {corner(), corner(), corner()};
     }},
};

float largestCoordinate(const GnoCaster& t) {
    const vec3 m = max(abs(t.a), max(abs(t.b), abs(t.c)));
    return std::max(m.x, std::max(m.y, m.z));
}

/// A point of t as a rasteriser might hand it over: off by up to `ulps` * 2^-23 of the largest coordinate, and on no grid.
vec3 rasterised(Random& r, const GnoCaster& t, double ulps) {
    double u = 0.5 * r.real() + 0.5, v = 0.5 * r.real() + 0.5;
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const glm::dvec3 a(t.a), p = a + (glm::dvec3(t.b) - a) * u + (glm::dvec3(t.c) - a) * v;
    glm::dvec3 off(r.real(), r.real(), r.real());
    while (glm::dot(off, off) > 1) off = glm::dvec3(r.real(), r.real(), r.real());
    return vec3(p + off * (ulps * 0x1p-23 * double(largestCoordinate(t))));
}

int exactSide(const GnoCaster& t, vec3 p) { return exact::orient3d(exact::fixed(t.a), exact::fixed(t.b), exact::fixed(t.c), exact::fixed(p)); }

/// Exact side of a homogeneous point, a light or a viewer.
int exactSide(const GnoCaster& t, vec4 x) { return -exact::orient3dLight(x, exact::fixed(t.a), exact::fixed(t.b), exact::fixed(t.c)); }

class MakeViewSample : public testing::TestWithParam<Shape> {};

TEST_P(MakeViewSample, LiesStrictlyOnTheViewersSideOfItsOwnPlane) {
    Random r(3);
    uint64_t made = 0, away = 0, collinear = 0, unsure = 0;
    double longest = 0;  // in units of 2 * (8 ulp M + 2^-40)
    for (int i = 0; i < 40000; ++i) {
        const GnoCaster t = GetParam().make(r);
        const vec3 p = rasterised(r, t, i % 4 == 0 ? 0 : i % 4 == 1 ? 0.5 : i % 4 == 2 ? 4 : 7.5);
        const vec4 viewer = questions::light(r, r.uniform()), light = questions::light(r, r.below(8) == 0 ? r.onPlane(t.a, t.b, t.c) : r.uniform());
        const uint own = uint(i);
        const GnoViewSample sample = gnoMakeViewSample(p, own, t, viewer, light);
        const questions::Question q{light, t, p};

        const vec3 normal = gnoTurnedNormal(t, p, viewer);
        const exact::Wide exactNormal =
            exact::cross(exact::operator-(exact::fixed(t.b), exact::fixed(t.a)), exact::operator-(exact::fixed(t.c), exact::fixed(t.a)));
        if (exactNormal[0] == 0 && exactNormal[1] == 0 && exactNormal[2] == 0) {
            ++collinear;
            ASSERT_EQ(sample.own, GNO_FACING_AWAY) << show(q);
            ASSERT_EQ(normal, vec3(0.0f)) << show(q);
            continue;
        }
        // The side that the normal was turned to, and that it is the viewer's unless the viewer is in the plane but for rounding.
        double along = 0;
        for (int k = 0; k < 3; ++k) along += double(normal[k]) * double(exactNormal[size_t(k)]);
        const int side = along > 0 ? 1 : -1;
        const glm::dvec3 toViewer = glm::dvec3(vec3(viewer)) - glm::dvec3(p) * double(viewer.w);
        const double clear = std::fabs(glm::dot(glm::dvec3(normal), toViewer)) / glm::length(toViewer);
        const double off = viewer.w * 16 * 0x1p-23 * double(largestCoordinate(t)) / glm::length(toViewer);
        if (clear > 1e-5 + off) {
            ASSERT_EQ(exactSide(t, viewer), side) << show(q);
        } else {
            ++unsure;
        }

        if (exactSide(t, light) != side) {
            ++away;
            ASSERT_EQ(sample.own, GNO_FACING_AWAY) << show(q);
            continue;
        }
        ++made;
        ASSERT_EQ(sample.own, own) << show(q);
        ASSERT_EQ(exactSide(t, sample.position), side) << show(q);
        ASSERT_EQ(gnoSnapToGrid(sample.position), sample.position) << show(q);
        const bool shadowed = exact::inShadowOf(light, exact::fixed(t.a), exact::fixed(t.b), exact::fixed(t.c), exact::fixed(sample.position));
        ASSERT_FALSE(shadowed) << "darkened by its own caster\n" << show(q);
        const double allowed = 2 * (8 * 0x1p-23 * double(largestCoordinate(t)) + 0x1p-40);
        longest = std::max(longest, glm::length(glm::dvec3(sample.position) - glm::dvec3(p)) / allowed);
    }
    RecordProperty("longest_move", std::to_string(longest));
    RecordProperty("facing_away", std::to_string(away));
    EXPECT_GT(made, 10000u);
    EXPECT_GT(away, 10000u);
    EXPECT_LT(collinear, 4000u);
    EXPECT_LT(unsure, 4000u);
    EXPECT_LE(longest, 1.0) << "in units of 2 (8 ulp M + 2^-40)";
    EXPECT_GT(longest, 0.3) << "nothing was moved: this test looks at nothing";
}

INSTANTIATE_TEST_SUITE_P(, MakeViewSample, testing::ValuesIn(kShapes), [](const auto& shape) { return std::string(shape.param.name); });

TEST(MakeViewSampleTwo, BothSidesOfOneTriangle) {
    const GnoCaster t{vec3(-0.5f, -0.5f, 0.25f), vec3(0.5f, -0.5f, 0.25f), vec3(0, 0.5f, 0.25f)};
    const vec4 above(0, 0, 0.75f, 1), below(0, 0, -0.75f, 1);
    EXPECT_GT(gnoMakeViewSample(vec3(0, 0, 0.25f), 7, t, above, above).position.z, 0.25f);
    EXPECT_LT(gnoMakeViewSample(vec3(0, 0, 0.25f), 7, t, below, below).position.z, 0.25f);
    EXPECT_EQ(gnoMakeViewSample(vec3(0, 0, 0.25f), 7, t, above, above).own, 7u);
    EXPECT_EQ(gnoMakeViewSample(vec3(0, 0, 0.25f), 7, t, above, below).own, GNO_FACING_AWAY);
    EXPECT_EQ(gnoMakeViewSample(vec3(0, 0, 0.25f), 7, t, above, vec4(0.75f, 0, 0.25f, 1)).own, GNO_FACING_AWAY) << "a light in the plane";
    EXPECT_EQ(gnoMakeViewSample(vec3(0, 0, 0.25f), 7, t, above, vec4(1, 0, 0, 0)).own, GNO_FACING_AWAY) << "a direction in the plane";
    EXPECT_EQ(gnoMakeViewSample(vec3(0, 0, 0.25f), 7, t, above, vec4(1, 0, 0x1p-40f, 0)).own, 7u) << "a direction just above the plane";
}

/// A rasteriser that is off by far more than was ever measured: the step is doubled until the side is right.
TEST(MakeViewSampleTwo, FarOffPositionsAreBroughtBack) {
    Random r(5);
    for (int i = 0; i < 20000; ++i) {
        const GnoCaster t{r.uniform(), r.uniform(), r.uniform()};
        const vec3 p = rasterised(r, t, 4096);
        const vec4 eye = vec4(r.uniform(), 1);
        const GnoViewSample sample = gnoMakeViewSample(p, 1, t, eye, eye);
        if (sample.own == GNO_FACING_AWAY) continue;  // the eye sees the plane edge-on
        ASSERT_EQ(exactSide(t, sample.position), exactSide(t, eye)) << show({eye, t, p});
    }
}

TEST(PackViewSample, RoundTripKeepsEveryBit) {
    Random r(6);
    for (int i = 0; i < 1000; ++i) {
        GnoViewSample s{r.anyExponent(), uint(r.below(1 << 30))};
        if (i % 3 == 0) s.own = GNO_BACKGROUND;
        const GnoViewSample back = gnoUnpackViewSample(gnoPackViewSample(s));
        for (int k = 0; k < 3; ++k) ASSERT_EQ(bits(back.position[k]), bits(s.position[k]));
        ASSERT_EQ(back.own, s.own);
    }
}

}  // namespace
}  // namespace gno
