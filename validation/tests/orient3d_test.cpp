// SPDX-License-Identifier: MIT
// core/orient3d.glsl, compiled as C++, against __int128 on random and adversarial questions. With GNOMON_LONG=1 in the environment: 10^8 of them.
#include <gtest/gtest.h>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include <cfenv>
#include <cstdlib>
#include <string>

#include "validation/support/exact_reference.hpp"
#include "validation/support/glsl_as_cpp.hpp"
#include "validation/support/grid_questions.hpp"

namespace gno {
namespace {
uint64_t exactCalls = 0;
}
#define GNO_ORIENT3D_ON_EXACT ++exactCalls
#include "glsl/core/orient3d.glsl"
#undef GNO_CORE_ORIENT3D_GLSL
#undef GNO_ORIENT3D_FILTER
#undef GNO_ORIENT3D_ON_EXACT
namespace unfiltered {
struct GnoCaster {  // a type of its own, so that argument-dependent lookup finds the functions of this copy only
    vec3 a, b, c;
};
#define GNO_ORIENT3D_FILTER 0
#include "glsl/core/orient3d.glsl"
}  // namespace unfiltered
}  // namespace gno

namespace {

using glm::vec3;
using glm::vec4;
using gno::GnoCaster;
using gno::exact::operator-;
using gno::questions::Family;
using gno::questions::kFamilies;
using gno::questions::Question;
using gno::questions::Random;
using gno::questions::show;
using gno::questions::snap;

gno::unfiltered::GnoCaster copy(const GnoCaster& t) { return {t.a, t.b, t.c}; }

/// `count` times 50 under GNOMON_LONG=1.
int many(int count) {
    const char* wanted = std::getenv("GNOMON_LONG");
    return wanted != nullptr && std::string(wanted) == "1" ? count * 50 : count;
}

void flushDenormals() {
#ifdef __SSE2__
    _mm_setcsr(_mm_getcsr() | 0x8040u);  // flush to zero, denormals are zero
#endif
}

class Orient3d : public testing::TestWithParam<Family> {};

TEST_P(Orient3d, SignsAreExact) {
    Random r(1);
    uint64_t signs = 0, zeros = 0, fp32Wrong = 0;
    gno::exactCalls = 0;
    for (int i = many(100000); i-- > 0;) {
        const Question q = GetParam().make(r);
        const gno::exact::Vec a = gno::exact::fixed(q.t.a), b = gno::exact::fixed(q.t.b), c = gno::exact::fixed(q.t.c), p = gno::exact::fixed(q.p);
        const int cap = gno::exact::orient3d(a, b, c, p);
        ASSERT_EQ(gno::gnoOrient3d(q.t.a, q.t.b, q.t.c, q.p), cap) << show(q);
        ASSERT_EQ(gno::unfiltered::gnoOrient3d(q.t.a, q.t.b, q.t.c, q.p), cap) << show(q);
        ASSERT_EQ(gno::gnoOrient3d(q.p, q.t.b, q.t.a, q.t.c), cap) << show(q);   // an even permutation of (a, b, c, p)
        ASSERT_EQ(gno::gnoOrient3d(q.t.c, q.t.b, q.t.a, q.p), -cap) << show(q);  // an odd one
        const int facing = gno::exact::orient3dLight(q.light, a, b, c);
        ASSERT_EQ(gno::gnoFacing(q.light, q.t), facing) << show(q);
        ASSERT_EQ(gno::unfiltered::gnoFacing(q.light, copy(q.t)), facing) << show(q);
        ASSERT_EQ(gno::gnoOrient3dLight(q.light, q.t.b, q.t.a, q.t.c), -facing) << show(q);
        const int lateral = gno::exact::orient3dLight(q.light, a, b, p);
        ASSERT_EQ(gno::gnoOrient3dLight(q.light, q.t.a, q.t.b, q.p), lateral) << show(q);
        ASSERT_EQ(gno::unfiltered::gnoOrient3dLight(q.light, q.t.a, q.t.b, q.p), lateral) << show(q);
        signs += 6;
        zeros += (cap == 0 ? 1u : 0u) + (facing == 0 ? 1u : 0u) + (lateral == 0 ? 1u : 0u);
        const float fp32 = dot(cross(q.t.b - q.t.a, q.t.c - q.t.a), q.p - q.t.a);
        fp32Wrong += (fp32 > 0.0f) - (fp32 < 0.0f) != cap ? 1u : 0u;
    }
    RecordProperty("exact_percent", std::to_string(100.0 * static_cast<double>(gno::exactCalls) / static_cast<double>(signs)));
    RecordProperty("zero_percent", std::to_string(200.0 * static_cast<double>(zeros) / static_cast<double>(signs)));
    RecordProperty("fp32_wrong", std::to_string(fp32Wrong));
    if (std::string(GetParam().name) == "Uniform") {
        EXPECT_LT(gno::exactCalls * 1000, signs) << "the filter hardly decides anything";
    }
    if (std::string(GetParam().name) == "PointNearCap") {
        EXPECT_GT(fp32Wrong, 1000u) << "these questions are too easy to prove anything";
        EXPECT_GT(gno::exactCalls, 1000u);
    }
}

TEST_P(Orient3d, InShadowOfFollowsTheDefinition) {
    Random r(2);
    uint64_t inShadow = 0;
    gno::exactCalls = 0;
    const int count = many(100000);
    for (int i = 0; i < count; ++i) {
        Question q = GetParam().make(r);
        if (r.below(2) == 0) {  // half of the points: behind the caster, or on the edge of its volume
            const double s = 0.5 * r.real() + 0.5, t = (0.5 * r.real() + 0.5) * (1 - s) * (r.below(4) == 0 ? 0 : 1), k = 0.5 + r.real();
            const glm::dvec3 a(q.t.a), on = a + (glm::dvec3(q.t.b) - a) * s + (glm::dvec3(q.t.c) - a) * t, l(vec3(q.light));
            q.p = r.nudge(q.light.w != 0.0f ? on + (on - l) * k : on - l * k);
        }
        const bool want =
            gno::exact::inShadowOf(q.light, gno::exact::fixed(q.t.a), gno::exact::fixed(q.t.b), gno::exact::fixed(q.t.c), gno::exact::fixed(q.p));
        ASSERT_EQ(gno::gnoInShadowOf(q.light, q.t, q.p), want) << show(q);
        ASSERT_EQ(gno::unfiltered::gnoInShadowOf(q.light, copy(q.t), q.p), want) << show(q);
        inShadow += want ? 1u : 0u;
    }
    RecordProperty("in_shadow", std::to_string(inShadow));
    RecordProperty("exact_per_question", std::to_string(static_cast<double>(gno::exactCalls) / count));
    EXPECT_GT(inShadow, 0u);
    EXPECT_LT(inShadow, static_cast<uint64_t>(count));
}

TEST_P(Orient3d, NormalsAreExactButForTheLastRounding) {
    Random r(3);
    for (int i = many(50000); i-- > 0;) {
        const Question q = GetParam().make(r);
        const gno::exact::Vec a = gno::exact::fixed(q.t.a);
        const gno::exact::Wide want = gno::exact::cross(gno::exact::fixed(q.t.b) - a, gno::exact::fixed(q.t.c) - a);
        const vec3 got = gno::gnoExactNormal(q.t);
        long double gotSize = 0;
        int highest = -1;  // bit of the largest component
        for (size_t k = 0; k < 3; ++k) {
            for (gno::exact::Int128 rest = want[k] < 0 ? -want[k] : want[k]; rest >> (highest + 1) != 0;) {
                ++highest;
            }
            gotSize = std::fmax(gotSize, std::fabs(static_cast<long double>(got[static_cast<int>(k)])));
        }
        if (highest < 0) {
            ASSERT_EQ(got, vec3(0.0f)) << show(q);
            continue;
        }
        ASSERT_TRUE(gotSize >= 0.5L && gotSize <= 1.0L) << show(q);
        const int scale = -1 - highest;
        for (size_t k = 0; k < 3; ++k) {
            const long double exact = std::ldexp(static_cast<long double>(want[k]), scale);
            ASSERT_LE(std::fabs(static_cast<long double>(got[static_cast<int>(k)]) - exact), std::fabs(exact) * 0x1p-22L) << show(q);
        }
    }
}

/// A device may round either way and flush denormals: a sign that the filter is certain of is right all the same.
TEST_P(Orient3d, FilterIsNeverWrongInAnyRoundingMode) {
    constexpr int kModes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    // Through volatile pointers: the compiler must not compute anything before the mode is set.
    int (*volatile orient)(vec3, vec3, vec3, vec3) = gno::gnoOrient3d;
    int (*volatile facingOf)(vec4, GnoCaster) = gno::gnoFacing;
    bool (*volatile inShadowOf)(vec4, GnoCaster, vec3) = gno::gnoInShadowOf;
    Random r(4);
    for (int i = many(20000); i-- > 0;) {
        const Question q = GetParam().make(r);
        const gno::exact::Vec a = gno::exact::fixed(q.t.a), b = gno::exact::fixed(q.t.b), c = gno::exact::fixed(q.t.c), p = gno::exact::fixed(q.p);
        const int cap = gno::exact::orient3d(a, b, c, p);
        const int facing = gno::exact::orient3dLight(q.light, a, b, c);
        const bool inShadow = gno::exact::inShadowOf(q.light, a, b, c, p);
        for (const int mode : kModes) {
            std::fenv_t before;
            std::fegetenv(&before);
            std::fesetround(mode);
            flushDenormals();
            const int gotCap = orient(q.t.a, q.t.b, q.t.c, q.p);
            const int gotFacing = facingOf(q.light, q.t);
            const bool gotInShadow = inShadowOf(q.light, q.t, q.p);
            std::fesetenv(&before);
            ASSERT_EQ(gotCap, cap) << show(q);
            ASSERT_EQ(gotFacing, facing) << show(q);
            ASSERT_EQ(gotInShadow, inShadow) << show(q);
        }
    }
}

/// The derived bound is not only safe but near the truth; a bound a few times smaller would be wrong on these questions.
TEST(Orient3dFilter, WorstErrorIsBelowTheBoundAndNotFarBelow) {
    constexpr int kModes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    void (*volatile crossOf)(vec3, vec3, vec3&, vec3&) = gno::gnoCrossFilter_;
    float (*volatile dotOf)(vec3, vec3) = gno::gnoDotFilter_;
    vec3 (*volatile differenceOf)(vec3, vec3) = gno::gnoDifferenceFloat_;
    Random r(5);
    double worst = 0;
    for (const Family& family : kFamilies) {
        for (int i = many(20000); i-- > 0;) {
            const Question q = family.make(r);
            std::fesetround(kModes[i % 4]);
            vec3 cross, crossMagnitude;
            const vec3 x = differenceOf(q.t.a, q.p);
            crossOf(differenceOf(q.t.b, q.p), differenceOf(q.t.c, q.p), cross, crossMagnitude);
            const float det = dotOf(x, cross);
            const float magnitude = dotOf(abs(x), crossMagnitude);
            std::fesetround(FE_TONEAREST);
            const gno::exact::Vec p = gno::exact::fixed(q.p);
            const gno::exact::Int128 exact =
                gno::exact::det(gno::exact::fixed(q.t.a) - p, gno::exact::fixed(q.t.b) - p, gno::exact::fixed(q.t.c) - p);
            const gno::exact::Int128 error = exact - static_cast<gno::exact::Int128>(std::ldexp(static_cast<long double>(det), 120));
            if (magnitude == 0.0f) {
                ASSERT_EQ(gno::exact::sign(exact), 0);
            } else {
                worst = std::fmax(worst, std::fabs(static_cast<double>(error)) / std::ldexp(static_cast<double>(magnitude), 120));
            }
        }
    }
    RecordProperty("worst_error_in_units_of_2^-23", std::to_string(worst * 0x1p23));
    EXPECT_LT(worst, static_cast<double>(gno::GNO_ORIENT3D_BOUND_));
    EXPECT_GT(worst, static_cast<double>(gno::GNO_ORIENT3D_BOUND_) / 8);
}

INSTANTIATE_TEST_SUITE_P(, Orient3d, testing::ValuesIn(kFamilies), [](const auto& family) { return std::string(family.param.name); });

TEST(Int128, FixedPointReadsEveryGridNumber) {
    for (int exponent = -40; exponent <= 0; ++exponent) {
        for (const double mantissa : {1.0, 1.25, 1.5, 1 + 0x1p-23, 2 - 0x1p-23}) {
            const float x = snap(std::ldexp(mantissa, exponent));
            const int64_t want = gno::exact::fixed(vec3(x, -x, 0.0f))[0];
            const gno::GnoInt64x3_ got = gno::gnoFixed_(vec3(x, -x, -0.0f));
            const auto join = [&](int i) { return static_cast<int64_t>(uint64_t{got.w1_[i]} << 32 | got.w0_[i]); };
            EXPECT_EQ(join(0), want);
            EXPECT_EQ(join(1), -want);
            EXPECT_EQ(join(2), 0);
        }
    }
}

TEST(Orient3dBox, LargestDeterminantOfTheContractFits) {
    const float m = 1.5f;
    EXPECT_EQ(gno::unfiltered::gnoOrient3d(vec3(-m, -m, -m), vec3(m, m, -m), vec3(m, -m, m), vec3(-m, m, m)), -1);
    EXPECT_EQ(gno::unfiltered::gnoOrient3d(vec3(-m, -m, -m), vec3(m, -m, m), vec3(m, m, -m), vec3(-m, m, m)), 1);
}

}  // namespace
