// SPDX-License-Identifier: MIT
// The oracle's signs against 128-bit integer determinants, and its definition on cases that a reader can check by eye.
#include <gtest/gtest.h>

#include "validation/oracle/definition.hpp"
#include "validation/tests/oracle_cases.hpp"

namespace {

using namespace gno::host;
using namespace gno::host::oracle;
using cases::Random;

__extension__ using Int128 = __int128;

struct Units {  // multiples of 2^-40
    int64_t x, y, z;
    friend Units operator-(Units a, Units b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
};

Units units(glm::vec3 v) { return {int64_t(std::ldexp(v.x, 40)), int64_t(std::ldexp(v.y, 40)), int64_t(std::ldexp(v.z, 40))}; }

// Differences in [-2, 2] are 2^41 units at most, so the determinant stays below 6 * 2^123.
int determinantSign(Units u, Units v, Units w) {
    const Int128 d = u.x * (Int128(v.y) * w.z - Int128(v.z) * w.y) - u.y * (Int128(v.x) * w.z - Int128(v.z) * w.x) +
                     u.z * (Int128(v.x) * w.y - Int128(v.y) * w.x);
    return d > 0 ? 1 : d < 0 ? -1 : 0;
}

// The same in double: what a hasty oracle would do.
int roundedSign(glm::dvec3 u, glm::dvec3 v, glm::dvec3 w) {
    const double d = glm::dot(u, glm::cross(v, w));
    return d > 0 ? 1 : d < 0 ? -1 : 0;
}

struct Tally {
    int zero = 0, positive = 0, negative = 0, roundedWrong = 0;
    void count(int sign, int rounded) {
        (sign == 0 ? zero : sign > 0 ? positive : negative) += 1;
        roundedWrong += sign != rounded;
    }
};

// Compares all signs of four points: a point light at d, and d as a direction (towards the light).
void compare(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, Tally& tally) {
    const Units ua = units(a), ub = units(b), uc = units(c), ud = units(d);
    const int four = determinantSign(ub - ua, uc - ua, ud - ua);
    ASSERT_EQ(orient3d(a, b, c, d), four);
    ASSERT_EQ(orient3d(a, b, c, glm::vec4(d, 1)), four);
    ASSERT_EQ(orient3d(glm::vec4(d, 1), a, b, c), determinantSign(ua - ud, ub - ud, uc - ud));
    tally.count(four, roundedSign(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a), glm::dvec3(d) - glm::dvec3(a)));

    const int direction = determinantSign(ub - ua, uc - ua, ud);
    ASSERT_EQ(orient3d(a, b, c, glm::vec4(d, 0)), direction);
    ASSERT_EQ(orient3d(glm::vec4(d, 0), a, b, c), -determinantSign(ud, ub - ua, uc - ua));
    tally.count(direction, roundedSign(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a), glm::dvec3(d)));
}

TEST(Signs, NumbersOfEverySize) {
    Random random(1);
    Tally tally;
    for (int i = 0; i < 100000; ++i)
        ASSERT_NO_FATAL_FAILURE(compare(random.position(), random.position(), random.position(), random.position(), tally));
    EXPECT_GT(tally.zero, 1000);
    EXPECT_GT(tally.positive, 10000);
    EXPECT_GT(tally.negative, 10000);
}

TEST(Signs, RandomPoints) {
    Random random(2);
    Tally tally;
    for (int i = 0; i < 50000; ++i) {
        const glm::vec3 a = cases::snap(random.inCube()), b = cases::snap(random.inCube()), c = cases::snap(random.inCube());
        ASSERT_NO_FATAL_FAILURE(compare(a, b, c, cases::snap(random.inCube()), tally));
    }
}

TEST(Signs, CoplanarPointsAndTheirNeighbours) {
    Random random(3);
    Tally tally;
    for (int i = 0; i < 100000; ++i) {
        // Multiples of 2^-18 leave room: a + s u + t v with small whole s, t is exact in fp32.
        const auto coarse = [&] { return glm::vec3(glm::round(random.inCube(0.1) * 0x1p18)) * 0x1p-18f; };
        const glm::vec3 a = coarse(), u = coarse(), v = coarse();
        const float s = float(int(random.below(5)) - 2), t = float(int(random.below(5)) - 2);
        const glm::vec3 d = a + s * u + t * v;
        ASSERT_EQ(orient3d(a, a + u, a + v, d), 0);
        ASSERT_EQ(orient3d(a, a + u, a + v, glm::vec4(s * u + t * v, 0)), 0);
        const glm::vec3 near[4] = {a, a + u, a + v, d};
        const uint32_t moved = random.below(4);
        glm::vec3 p[4];
        for (uint32_t k = 0; k < 4; ++k) p[k] = k == moved ? cases::neighbour(near[k], random) : near[k];
        ASSERT_NO_FATAL_FAILURE(compare(p[0], p[1], p[2], p[3], tally));
    }
    EXPECT_GT(tally.positive, 10000);
    EXPECT_GT(tally.negative, 10000);
}

TEST(Signs, NearlyCoplanarAtFullPrecision) {
    Random random(4);
    Tally tally;
    for (int i = 0; i < 100000; ++i) {
        const glm::vec3 a = cases::snap(random.inCube()), b = cases::snap(random.inCube()), c = cases::snap(random.inCube());
        const double s = random.real(0, 1), t = random.real(0, 1 - s);
        const glm::dvec3 d = glm::dvec3(a) + s * (glm::dvec3(b) - glm::dvec3(a)) + t * (glm::dvec3(c) - glm::dvec3(a));
        ASSERT_NO_FATAL_FAILURE(compare(a, b, c, cases::snap(d), tally));
        const float tiny = std::ldexp(1.0f, -int(10 + random.below(15)));
        ASSERT_NO_FATAL_FAILURE(compare(a, cases::snap(glm::dvec3(a) + double(tiny) * random.inCube()), c, cases::snap(d), tally));
    }
}

TEST(Signs, CollinearPoints) {
    Random random(5);
    Tally tally;
    for (int i = 0; i < 20000; ++i) {
        const auto coarse = [&] { return glm::vec3(glm::round(random.inCube(0.2) * 0x1p18)) * 0x1p-18f; };
        const glm::vec3 a = coarse(), u = coarse(), b = a + u, c = a - 2.0f * u, d = random.position();
        ASSERT_EQ(orient3d(a, b, c, d), 0);
        ASSERT_EQ(orient3d(a, b, c, glm::vec4(d, 1)), 0);
        ASSERT_EQ(orient3d(a, b, c, glm::vec4(d, 0)), 0);
        ASSERT_EQ(orient3d(glm::vec4(d, 0), a, b, c), 0);
        ASSERT_EQ(orient3d(glm::vec4(u, 0), a, b, d), 0);
        // Seen from a fine point near zero, differences have up to 41 bits, and double makes something of nothing.
        const glm::vec3 fine = cases::snap(random.inCube(0x1p-17));
        ASSERT_NO_FATAL_FAILURE(compare(fine, a, b, c, tally));
        ASSERT_NO_FATAL_FAILURE(compare(fine, a, b, cases::neighbour(c, random), tally));
    }
    EXPECT_GT(tally.roundedWrong, 1000);
}

TEST(Signs, Convention) {
    const glm::vec3 o(0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    EXPECT_EQ(orient3d(o, x, y, z), 1);
    EXPECT_EQ(orient3d(o, y, x, z), -1);
    EXPECT_EQ(orient3d(o, x, y, glm::vec4(z, 1)), 1);
    EXPECT_EQ(orient3d(o, x, y, glm::vec4(z, 0)), 1);
    EXPECT_EQ(orient3d(glm::vec4(z, 0), o, x, y), -1);
    EXPECT_EQ(orient3d(glm::vec4(z, 1), o, x, y), -1);
}

// A caster in the plane z = 0, the light above it.
const Triangle kCaster{{0, 0, 0}, {0.5f, 0, 0}, {0, 0.5f, 0}};

struct Case {
    const char* why;
    glm::vec4 light;
    glm::vec3 p;
    bool shadow;
};

TEST(Definition, CasesByEye) {
    const glm::vec4 lamp(0, 0, 0.5f, 1), sun(0, 0, 1, 0), slanted(0.5f, 0, 1, 0), flat(1, 0, 0, 0), flatLamp(1, 1, 0, 1);
    const Case cases[] = {
        {"behind the middle", lamp, {0.25f, 0.25f, -0.25f}, true},
        {"in front of it", lamp, {0.0625f, 0.0625f, 0.25f}, false},
        {"on the caster", lamp, {0.125f, 0.125f, 0}, false},
        {"one unit behind the caster", lamp, {0.125f, 0.125f, -0x1p-40f}, true},
        {"one unit before the caster", lamp, {0.125f, 0.125f, 0x1p-40f}, false},
        {"behind vertex A", lamp, {0, 0, -0.5f}, true},
        {"behind vertex B", lamp, {1, 0, -0.5f}, true},
        {"behind edge AB", lamp, {0.5f, 0, -0.5f}, true},
        {"behind edge BC", lamp, {0.5f, 0.5f, -0.5f}, true},
        {"one unit outside edge AB", lamp, {0.5f, -0x1p-40f, -0.5f}, false},
        {"one unit inside edge AB", lamp, {0.5f, 0x1p-40f, -0.5f}, true},
        {"one ulp outside vertex B", lamp, {1 + 0x1p-23f, 0, -0.5f}, false},
        {"in the opposite cone, beyond the light", lamp, {-0.125f, -0.125f, 0.75f}, false},
        {"at the light", lamp, {0, 0, 0.5f}, false},
        {"vertex A itself", lamp, {0, 0, 0}, false},
        {"in the caster's plane beside it", lamp, {-0.5f, 0, 0}, false},
        {"behind, the sun above", sun, {0.125f, 0.125f, -1}, true},
        {"before, the sun above", sun, {0.125f, 0.125f, 0.5f}, false},
        {"on the caster, the sun above", sun, {0.125f, 0.125f, 0}, false},
        {"behind vertex C, the sun above", sun, {0, 0.5f, -0.25f}, true},
        {"behind edge BC, the sun above", sun, {0.25f, 0.25f, -0.25f}, true},
        {"one unit outside edge CA", sun, {-0x1p-40f, 0.25f, -0.25f}, false},
        {"shadow falls against a slanted direction", slanted, {-0.125f, 0.25f, -0.5f}, true},
        {"and not along it", slanted, {0.5f, 0.25f, -0.5f}, false},
        {"sun edge-on", flat, {-0.5f, 0.125f, 0}, false},
        {"sun edge-on, below", flat, {-0.5f, 0.125f, -0.25f}, false},
        {"lamp edge-on", flatLamp, {-0.5f, -0.5f, 0}, false},
        {"lamp edge-on, below", flatLamp, {0.125f, 0.125f, -0.25f}, false},
    };
    const Triangle turned{kCaster.a, kCaster.c, kCaster.b}, rotated{kCaster.b, kCaster.c, kCaster.a};
    for (const Case& c : cases) {
        for (const Triangle& t : {kCaster, turned, rotated}) EXPECT_EQ(inShadowOf(t, c.light, c.p), c.shadow) << c.why;
    }
}

// The open segment from p to the light meets the closed triangle in exactly one point: in rationals, with Cramer's rule on 128-bit integers.
bool segmentMeetsTriangle(const Triangle& t, glm::vec4 light, glm::vec3 p) {
    const Units u = units(t.b) - units(t.a), v = units(t.c) - units(t.a), l = units(glm::vec3(light)), s = units(p);
    const Units d = light.w != 0 ? l - s : l, r = s - units(t.a);  // p + k d = a + i u + j v
    const auto det = [](Units a, Units b, Units c) {
        return a.x * (Int128(b.y) * c.z - Int128(b.z) * c.y) - a.y * (Int128(b.x) * c.z - Int128(b.z) * c.x) +
               a.z * (Int128(b.x) * c.y - Int128(b.y) * c.x);
    };
    const Units back{-d.x, -d.y, -d.z};
    Int128 whole = det(u, v, back), i = det(r, v, back), j = det(u, r, back), k = det(u, v, r);
    if (whole == 0) return false;
    if (whole < 0) whole = -whole, i = -i, j = -j, k = -k;
    return i >= 0 && j >= 0 && i + j <= whole && k > 0 && (light.w == 0 || k < whole);
}

TEST(Definition, IsTheOpenSegmentAgainstTheClosedTriangle) {
    size_t shadowed = 0;
    for (uint32_t seed = 10; seed < 12; ++seed) {
        for (const cases::HardCase& c : cases::hardCases(seed, 300)) {
            for (const OracleSample& sample : c.samples) {
                for (const Triangle& t : c.triangles) {
                    const bool shadow = inShadowOf(t, c.light, sample.position);
                    ASSERT_EQ(shadow, segmentMeetsTriangle(t, c.light, sample.position)) << c.name;
                    const int facing = orient3d(t.a, t.b, t.c, c.light);
                    const bool fast = facing != 0 && inShadowOf(t, c.light, sample.position, facing);
                    ASSERT_EQ(shadow, fast) << c.name;
                    shadowed += shadow;
                }
            }
        }
    }
    EXPECT_GT(shadowed, 10000u);
}

}  // namespace
