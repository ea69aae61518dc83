// SPDX-License-Identifier: MIT
// The candidates: no box that a segment meets is ever rejected (exact rationals say which), and the tree's answers lose no caster.
#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "validation/oracle/caster_tree.hpp"
#include "validation/oracle/definition.hpp"
#include "validation/tests/oracle_cases.hpp"

namespace {

using namespace gno::host;
using namespace gno::host::oracle;
using cases::Random;

__extension__ using Int128 = __int128;
int64_t units(float v) { return int64_t(std::ldexp(v, 40)); }

// Does p + t d with 0 < t < 1 (or 0 < t) meet the closed box? Whole numbers only: bounds of t are fractions n / q with q > 0.
bool meets(glm::vec3 p, glm::vec4 light, const float (&low)[3], const float (&high)[3]) {
    struct Fraction {
        Int128 n, q;
        bool operator<(const Fraction& o) const { return n * o.q < o.n * q; }
    };
    Fraction enter{0, 1}, leave{1, 1};
    bool bounded = light.w != 0, entersLater = false, leavesEarlier = false;  // the interval's own ends are open, the box's are closed
    for (int axis = 0; axis < 3; ++axis) {
        const int64_t d = light.w != 0 ? units(light[axis]) - units(p[axis]) : units(light[axis]);
        const int64_t toLow = units(low[axis]) - units(p[axis]), toHigh = units(high[axis]) - units(p[axis]);
        if (d == 0) {
            if (toLow > 0 || toHigh < 0) return false;
            continue;
        }
        const Fraction in = d > 0 ? Fraction{toLow, d} : Fraction{-toHigh, -d}, out = d > 0 ? Fraction{toHigh, d} : Fraction{-toLow, -d};
        if (enter < in) enter = in, entersLater = true;
        if (!bounded || out < leave) leave = out, bounded = leavesEarlier = true;
    }
    if (!bounded || enter < leave) return true;
    return entersLater && leavesEarlier && !(leave < enter);  // one common point, and it is no open end
}

struct Boxed {
    float low[3], high[3];
};

Boxed around(glm::vec3 a, glm::vec3 b) {
    Boxed box;
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = std::min(a[axis], b[axis]);
        box.high[axis] = std::max(a[axis], b[axis]);
    }
    return box;
}

void attack(Random& random, int rounds, const std::function<glm::vec3()>& position) {
    int met = 0, rejected = 0, needless = 0;
    for (int i = 0; i < rounds; ++i) {
        const glm::vec3 p = position();
        const glm::vec4 light(position(), float(random.below(2)));
        if (light == glm::vec4(0)) continue;
        const glm::vec3 corner = position();
        glm::vec3 other = position();
        for (int axis = 0; axis < 3; ++axis) {
            if (random.below(3) == 0) other[axis] = corner[axis];  // flat boxes, needles and points
        }
        const Boxed box = around(corner, other);
        const bool exact = meets(p, light, box.low, box.high), kept = ShadowSegment(p, light).mayMeet(box.low, box.high);
        ASSERT_TRUE(kept || !exact) << "lost: round " << i;
        met += exact;
        rejected += !kept;
        needless += kept && !exact;
    }
    EXPECT_GT(met, rounds / 100);
    EXPECT_GT(rejected, rounds / 10);
    EXPECT_LT(needless, rounds / 4);
}

TEST(Segment, NeverRejectsABoxItMeetsOnALattice) {
    Random random(1);
    attack(random, 400000, [&] { return random.lattice(4); });
}

TEST(Segment, NeverRejectsABoxItMeetsWithNumbersOfEverySize) {
    Random random(2);
    attack(random, 400000, [&] { return random.position(); });
}

TEST(Segment, NeverRejectsABoxAFewUnitsAcross) {
    Random random(3);
    const auto few = [&] { return float(int(random.below(7)) - 3) * cases::kUnit; };
    attack(random, 400000, [&] {
        const float x = few(), y = few(), z = few();
        return glm::vec3(x, y, z);
    });
}

TEST(Segment, NeverRejectsAPointOfItself) {
    Random random(4);
    for (int i = 0; i < 200000; ++i) {  // the middle is exact in double; its neighbours on the grid box it
        const glm::vec3 p = random.position(), l = random.position();
        const glm::dvec3 middle = (glm::dvec3(p) + glm::dvec3(l)) / 2.0;
        Boxed box;
        for (int axis = 0; axis < 3; ++axis) {
            const float near = cases::snap(middle[axis]);
            const float step = std::max(cases::kUnit, std::nextafter(std::abs(near), 4.0f) - std::abs(near));
            box.low[axis] = near - step;
            box.high[axis] = near + step;
        }
        if (p == l) continue;
        ASSERT_TRUE(meets(p, glm::vec4(l, 1), box.low, box.high));
        ASSERT_TRUE(ShadowSegment(p, glm::vec4(l, 1)).mayMeet(box.low, box.high));
    }
}

std::vector<uint32_t> everyIndex(size_t count) {
    std::vector<uint32_t> out(count);
    std::iota(out.begin(), out.end(), 0u);
    return out;
}

TEST(Tree, HoldsEveryCasterOnceAndNamesEveryShadowingOne) {
    for (const cases::HardCase& c : cases::hardCases(7, 60)) {
        const CasterTree tree(c.triangles, everyIndex(c.triangles.size()), {});
        for (const OracleSample& sample : c.samples) {
            std::multiset<uint32_t> named;
            const bool stopped = tree.any(ShadowSegment(sample.position, c.light), [&](uint32_t t) {
                named.insert(t);
                return false;
            });
            ASSERT_FALSE(stopped);
            for (uint32_t t = 0; t < c.triangles.size(); ++t) {
                ASSERT_LE(named.count(t), 1u) << c.name;
                const bool shadows = inShadowOf(c.triangles[t], c.light, sample.position);
                ASSERT_TRUE(!shadows || named.count(t) == 1) << c.name << ", caster " << t;
            }
        }
    }
}

TEST(Tree, PrunesMostOfALargeScene) {
    Random random(8);
    const auto triangles = cases::heightField(100, random);
    const CasterTree tree(triangles, everyIndex(triangles.size()), {});
    size_t named = 0;
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 p = cases::snap(random.inCube(0.4) * glm::dvec3(1, 0, 1) + glm::dvec3(0, -0.25, 0));
        tree.any(ShadowSegment(p, glm::vec4(0, 1, 0, 0)), [&](uint32_t) { return ++named, false; });
    }
    EXPECT_GE(named, 100u);    // each ray crosses the field
    EXPECT_LT(named, 10000u);  // of 20,000 casters a hundred at most are looked at
}

TEST(Tree, SurvivesManyEqualCastersAndAGeometricSeries) {
    std::vector<Triangle> equal(5000, Triangle{{0, 0, 0}, {0.5f, 0, 0}, {0, 0.5f, 0}});
    const CasterTree same(equal, everyIndex(equal.size()), {});
    size_t named = 0;
    same.any(ShadowSegment({0.125f, 0.125f, -0.5f}, glm::vec4(0, 0, 1, 0)), [&](uint32_t) { return ++named, false; });
    EXPECT_EQ(named, equal.size());

    std::vector<Triangle> series;  // each split peels off little: the deepest tree that the grid allows
    for (int k = 0; k <= 38; ++k) {
        for (int copy = 0; copy < 50; ++copy) {
            const float x = std::ldexp(1.0f, -k);
            series.push_back({{x, 0, 0}, {x, 0.5f, 0}, {x, 0, 0.5f}});
        }
    }
    const CasterTree deep(series, everyIndex(series.size()), {});
    named = 0;
    deep.any(ShadowSegment({-1, 0.125f, 0.125f}, glm::vec4(1, 0, 0, 0)), [&](uint32_t) { return ++named, false; });
    EXPECT_EQ(named, series.size());
}

TEST(Tree, ReportsProgressAndCanBeStopped) {
    const std::vector<Triangle> many(200000, Triangle{{0, 0, 0}, {0.5f, 0, 0}, {0, 0.5f, 0}});
    int calls = 0;
    const CasterTree tree(many, everyIndex(many.size()), [&](double part) {
        EXPECT_TRUE(part > 0 && part <= 1);
        ++calls;
    });
    EXPECT_GE(calls, 2);
    struct Stop {};
    EXPECT_THROW(CasterTree(many, everyIndex(many.size()), [](double) { throw Stop(); }), Stop);
}

}  // namespace
