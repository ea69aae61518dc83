// SPDX-License-Identifier: MIT
// The three queries of a TOP tree on trees written by hand: one case each for what a query can meet on its way.
#include <gtest/gtest.h>

#include <functional>

#include "validation/tests/top_hand_made.hpp"

namespace gno {
namespace {

using host::OracleSample;
using host::Precision;
using test::HandAnswer;
using test::HandQuery;
using test::HandTree;

constexpr uint32_t kLit = GNO_VISIBILITY_LIT, kDark = GNO_VISIBILITY_SHADOW;
constexpr float kAll = 10;  // a wedge that admits everything
constexpr auto kEvery = {Precision::published, Precision::conservative, Precision::certified};
constexpr auto kOwnAware = {Precision::conservative, Precision::certified};
const glm::vec4 kFromAbove{0, 1, 0, 0};  // directional

std::vector<HandQuery> queries(uint32_t stack) { return {{"psv", stack}, {"d-psv", stack}, {"d-stackless", 0}, {"d-hybrid", stack}}; }

/// A triangle half a unit from the light at the origin, about the axis +z, moved aside; its shadow is a cone around (x, y, 1/2) t, t > 1.
host::Triangle target(float x, float y) { return {{x - 0.0625f, y - 0.0625f, 0.5f}, {x + 0.0625f, y - 0.0625f, 0.5f}, {x, y + 0.0625f, 0.5f}}; }
/// `far` times the way from the light to the middle of target(x, y): below 1 in front of it, above 1 behind.
OracleSample behind(float x, float y, float far = 1.5f, uint32_t own = host::kNoCaster) { return {{x * far, y * far, 0.5f * far}, own}; }

void expectAll(const HandTree& tree, const std::vector<OracleSample>& samples, const std::vector<uint32_t>& want,
               const std::vector<uint32_t>& stacks = {1, 12}) {
    for (const uint32_t stack : stacks)
        for (const HandQuery& query : queries(stack))
            EXPECT_EQ(tree.ask(samples, query).visibility, want) << query.name << " stack " << stack << ", " << name(tree.precision());
}

TEST(TopQuery, EmptyTreeIsLit) {
    for (const auto precision : kEvery) expectAll(HandTree(precision), {behind(0, 0), behind(0.25f, 0)}, {kLit, kLit}, {12});
}

// Outside each lateral plane, in front of the cap, inside.
TEST(TopQuery, OneVolumeFiveRegions) {
    for (const auto precision : kEvery) {
        HandTree point(precision);
        point.add(target(0, 0));
        expectAll(point, {behind(0, -0.25f), behind(0.25f, 0.125f), behind(-0.25f, 0.125f), behind(0, 0, 0.5f), behind(0, 0)},
                  {kLit, kLit, kLit, kLit, kDark}, {12});
        HandTree directional(precision, kFromAbove);
        directional.add({{-0.25f, 0, -0.25f}, {0.25f, 0, -0.25f}, {0, 0, 0.25f}});
        expectAll(directional,
                  {{{0, -0.5f, -0.5f}, host::kNoCaster},
                   {{0.5f, -0.5f, 0}, host::kNoCaster},
                   {{-0.5f, -0.5f, 0}, host::kNoCaster},
                   {{0, 0.25f, 0}, host::kNoCaster},
                   {{0, -0.25f, 0}, host::kNoCaster}},
                  {kLit, kLit, kLit, kLit, kDark}, {12});
    }
}

// Both windings of a caster make the same volume.
TEST(TopQuery, WindingDoesNotMatter) {
    for (const auto precision : kEvery) {
        HandTree tree(precision);
        host::Triangle turned = target(0, 0);
        std::swap(turned.b, turned.c);
        tree.add(turned);
        expectAll(tree, {behind(0, 0), behind(0, 0, 0.5f), behind(0.25f, 0)}, {kDark, kLit, kLit}, {12});
    }
}

// The caster that a sample lies on never shadows it; others do, in front of it as well as behind.
TEST(TopQuery, OwnCasterIsSkipped) {
    for (const auto precision : kOwnAware) {
        HandTree tree(precision);
        const uint32_t own = tree.add(target(0, 0));
        const uint32_t other = tree.add({{-0.125f, -0.125f, 0.25f}, {0.125f, -0.125f, 0.25f}, {0, 0.125f, 0.25f}});
        tree.positive(4 * own + 3, other, GNO_TOP_NONE);
        expectAll(tree, {behind(0, 0, 0.5f, own), behind(0, 0, 0.75f, own), behind(0, 0, 1.5f, other)}, {kLit, kDark, kDark}, {12});
        HandTree alone(precision);
        alone.add(target(0, 0));
        expectAll(alone, {behind(0, 0, 1.5f, 0), behind(0, 0, 1.0f, 0), behind(0, 0, 1.5f)}, {kLit, kLit, kDark}, {12});
    }
}

// Root R and child C in the intersection subtree of R's second plane: a sample of either, of both, of none.
TEST(TopQuery, IntersectionChild) {
    for (const auto precision : kEvery) {
        HandTree tree(precision);
        const uint32_t root = tree.add(target(0, 0)), child = tree.add(target(0.0625f, 0));
        tree.intersection(4 * root + 1, child, kAll);
        expectAll(tree, {behind(-0.03125f, -0.03125f), behind(0.09375f, -0.03125f), behind(0.03125f, -0.03125f), behind(0.25f, 0), behind(0, 0.25f)},
                  {kDark, kDark, kDark, kLit, kLit});
    }
}

// The cap's intersection child has no wedge: its word is not looked at.
TEST(TopQuery, IntersectionChildOfTheCap) {
    for (const auto precision : kEvery) {
        HandTree tree(precision);
        const uint32_t root = tree.add(target(0, 0));
        const uint32_t child = tree.add({{-0.03125f, -0.03125f, 0.25f}, {0.03125f, -0.03125f, 0.25f}, {0, 0.03125f, 0.75f}});
        tree.intersection(4 * root + 3, child, 0);
        expectAll(tree, {{{0, -0.03125f, 0.4375f}, host::kNoCaster}, behind(0, 0), {{0.03125f, 0.03125f, 0.125f}, host::kNoCaster}},
                  {kDark, kDark, kLit});
    }
}

// Nobody goes where the wedge says there is nothing: with a literal that is too small the child is not seen.
TEST(TopQuery, WedgeIsObeyed) {
    for (const auto precision : kEvery) {
        HandTree tree(precision);
        const uint32_t root = tree.add(target(0, 0)), child = tree.add(target(0.25f, 0));
        tree.intersection(4 * root, child, 0);
        expectAll(tree, {behind(0.25f, 0)}, {kLit});
        tree.intersection(4 * root, child, kAll);
        expectAll(tree, {behind(0.25f, 0)}, {kDark});
    }
}

// Two children wait on the stack: the one that came last is visited first.
TEST(TopQuery, StackIsLastInFirstOut) {
    for (const auto precision : kEvery) {
        HandTree tree(precision);
        const uint32_t root = tree.add(target(0, 0)), first = tree.add(target(-0.25f, 0.25f)), last = tree.add(target(-0.375f, 0.125f));
        tree.intersection(4 * root, first, kAll);
        tree.intersection(4 * root + 1, last, kAll);
        const std::vector<OracleSample> samples{behind(-0.375f, 0.125f), behind(-0.25f, 0.25f)};
        for (const char* query : {"psv", "d-psv", "d-hybrid"}) {
            const HandAnswer answer = tree.ask(samples, {query, 12});
            EXPECT_EQ(answer.visibility, (std::vector<uint32_t>{kDark, kDark})) << query;
            EXPECT_EQ(answer.deepest[0], 2u) << query;
            EXPECT_EQ(answer.visited[0], 3u + 4u) << query;  // three planes of the root, then `last`
            EXPECT_GT(answer.visited[1], 3u + 4u) << query;  // `last` in vain, then `first`
        }
    }
}

// The same tree and one entry: what finds the stack full is lost by `published` and by nobody else; it is counted by all.
TEST(TopQuery, StackOverflow) {
    for (const auto precision : kEvery) {
        HandTree tree(precision);
        const uint32_t root = tree.add(target(0, 0)), first = tree.add(target(-0.25f, 0.25f)), last = tree.add(target(-0.375f, 0.125f));
        tree.intersection(4 * root, first, kAll);
        tree.intersection(4 * root + 1, last, kAll);
        const std::vector<OracleSample> samples{behind(-0.375f, 0.125f), behind(-0.25f, 0.25f), behind(-0.3125f, -0.3125f)};
        for (const char* query : {"psv", "d-psv"}) {
            const HandAnswer answer = tree.ask(samples, {query, 1});
            const std::vector<uint32_t> want{precision == Precision::published ? kLit : kDark, kDark, kLit};
            EXPECT_EQ(answer.visibility, want) << query << ", " << name(precision);
            EXPECT_EQ(answer.overflows[0], 1u) << query;
            EXPECT_EQ(answer.deepest[0], 1u) << query;
            EXPECT_EQ(tree.ask(samples, {query, 12}).overflows[0], 0u) << query;
        }
        EXPECT_EQ(tree.ask(samples, {"d-hybrid", 1}).visibility, (std::vector<uint32_t>{kDark, kDark, kLit})) << name(precision);
        EXPECT_GT(tree.ask(samples, {"d-hybrid", 1}).overflows[0], 0u);
    }
}

// Eight levels of intersection children, two a level, and stacks of every size up to more than enough.
TEST(TopQuery, EveryStackSizeOnAChain) {
    for (const auto precision : kOwnAware) {
        HandTree tree(precision);
        std::vector<OracleSample> samples;
        std::vector<uint32_t> want;
        uint32_t above = tree.add(target(0, -0.375f));
        for (int i = 0; i < 8; ++i) {
            const float x = 0.125f * float(i) - 0.5f;
            const uint32_t left = tree.add(target(x, 0.25f)), next = tree.add(target(x, 0)), side = tree.add(target(x, 0.4375f));
            tree.intersection(4 * above, left, kAll);
            tree.positive(4 * left + 1, side, 4 * above);
            tree.intersection(4 * above + 1, next, kAll);
            above = next;
            for (const float y : {0.25f, 0.0f, 0.4375f, 0.125f}) {
                samples.push_back(behind(x, y));
                want.push_back(y == 0.125f ? kLit : kDark);
            }
        }
        expectAll(tree, samples, want, precision == Precision::certified ? std::vector<uint32_t>{1, 3, 12} : std::vector<uint32_t>{1, 12});
    }
}

// One step back by an ancestor link leaves three volumes; what the root still has to say comes after that.
TEST(TopQuery, AncestorJumpsOverSeveralVolumes) {
    for (const auto precision : kEvery) {
        HandTree tree(precision);
        const uint32_t root = tree.add(target(0, 0));
        const uint32_t a = tree.add(target(0.375f, 0.375f)), b = tree.add(target(0.375f, 0)), c = tree.add(target(0.375f, -0.375f)),
                       e = tree.add(target(0.125f, 0.375f));
        const uint32_t late = tree.add(target(0, -0.25f));
        tree.intersection(4 * root, a, kAll);
        tree.positive(4 * a, b, 4 * root);      // below a: outside its first plane
        tree.positive(4 * b, c, 4 * root);      // and below b
        tree.intersection(4 * c + 1, e, kAll);  // a second level: back to c first
        tree.positive(4 * root, late, GNO_TOP_NONE);
        expectAll(tree, {behind(0, -0.25f), behind(0.375f, -0.375f), behind(0, 0), behind(0.375f, 0), behind(-0.25f, -0.4375f)},
                  {kDark, kDark, kDark, kDark, kLit});
    }
}

// A subtree whose least depth is beyond the sample is not visited by those that look at the depth; a literal that is too large shows it.
TEST(TopQuery, DepthSkipsAtTheRoot) {
    for (const auto precision : kEvery) {
        HandTree tree(precision);
        tree.add(target(0, 0));
        const std::vector<OracleSample> samples{behind(0, 0)};
        tree.leastDepth(0, 2.0f);
        EXPECT_EQ(tree.ask(samples, {"psv", 12}).visibility[0], kDark);
        for (const HandQuery& query : {HandQuery{"d-psv", 12}, HandQuery{"d-stackless", 0}, HandQuery{"d-hybrid", 12}}) {
            const HandAnswer answer = tree.ask(samples, query);
            EXPECT_EQ(answer.visibility[0], kLit) << query.name;
            EXPECT_EQ(answer.visited[0], 1u) << query.name;
        }
        tree.leastDepth(0, 0.25f);
        expectAll(tree, samples, {kDark}, {12});
    }
}

// A skipped subtree ends like any other: the search goes on at the ancestor, or with the stack.
TEST(TopQuery, DepthSkipsInASubtree) {
    for (const auto precision : kEvery) {
        HandTree tree(precision);
        const uint32_t root = tree.add(target(0, 0)), skipped = tree.add(target(0.25f, 0)), late = tree.add(target(0, -0.25f));
        tree.intersection(4 * root, skipped, kAll);
        tree.positive(4 * root, late, GNO_TOP_NONE);
        tree.leastDepth(skipped, 3.0f);
        expectAll(tree, {behind(0, -0.25f), behind(0, 0)}, {kDark, kDark});
    }
}

// Exactly on a lateral plane: the cone is closed. Exactly on the cap: not strictly behind, but what stands in front of the cap shadows it.
TEST(TopQuery, TiesOnPlanes) {
    const host::Triangle t = target(0, 0), front{{-0.125f, -0.125f, 0.25f}, {0.125f, -0.125f, 0.25f}, {0, 0.125f, 0.25f}};
    const auto on = [](glm::vec3 p) { return OracleSample{p, host::kNoCaster}; };
    const std::vector<OracleSample> samples{
        on((t.a + t.b) * 0.75f), on((t.b + t.c) * 0.75f), on((t.c + t.a) * 0.75f), on(t.a * 1.5f), on(t.b * 1.5f),
        on(t.c * 1.5f),          on({0, 0, 0.5f}),        on((t.a + t.b) * 0.5f),  on(t.a),        on((t.a + t.b) * 0.25f)};
    for (const auto precision : kEvery) {
        HandTree alone(precision);
        alone.add(t);
        HandTree covered(precision);
        const uint32_t root = covered.add(t), above = covered.add(front);
        covered.positive(4 * root + 3, above, GNO_TOP_NONE);
        for (const HandTree* tree : {&alone, &covered}) {
            const HandAnswer stackless = tree->ask(samples, {"d-stackless", 0});
            for (const HandQuery& query : queries(12))
                EXPECT_EQ(tree->ask(samples, query).visibility, stackless.visibility) << query.name << ", " << name(precision);
        }
        if (precision != Precision::certified) continue;
        EXPECT_EQ(alone.ask(samples, {"psv", 12}).visibility,
                  (std::vector<uint32_t>{kDark, kDark, kDark, kDark, kDark, kDark, kLit, kLit, kLit, kLit}));
        EXPECT_EQ(covered.ask({samples[6]}, {"psv", 12}).visibility[0], kDark);
    }
}

}  // namespace
}  // namespace gno
