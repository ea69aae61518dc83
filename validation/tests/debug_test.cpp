// SPDX-License-Identifier: MIT
// core/debug.glsl on the device: the queries of a TOP tree, compiled with GNO_DEBUG 1, end on trees that no build makes, and count what they found.
#include <gtest/gtest.h>

#include "validation/support/spirv_file.hpp"
#include "validation/tests/top_hand_made.hpp"

namespace gno {
namespace {

using host::OracleSample;
using host::Precision;
using test::HandAnswer;
using test::HandQuery;
using test::HandTree;

constexpr uint32_t kLit = GNO_VISIBILITY_LIT, kDark = GNO_VISIBILITY_SHADOW, kUnknown = GNO_VISIBILITY_UNKNOWN;

struct Case {
    HandQuery query;
    std::vector<uint32_t> shader;
};

std::vector<Case> cases() {
    std::vector<Case> result(3);
    const auto set = [&](size_t at, const char* name, uint32_t stack, const char* file) {
        result[at].query.name = name;
        result[at].query.stack = stack;
        result[at].shader = test::readSpirv(file);
    };
    set(0, "d-psv", 12, GNOMON_DEBUG_STACK);
    set(1, "d-stackless", 0, GNOMON_DEBUG_STACKLESS);
    set(2, "d-hybrid", 12, GNOMON_DEBUG_HYBRID);
    return result;
}

host::Triangle target(float x, float y) { return {{x - 0.0625f, y - 0.0625f, 0.5f}, {x + 0.0625f, y - 0.0625f, 0.5f}, {x, y + 0.0625f, 0.5f}}; }
OracleSample behind(float x, float y) { return {{x * 1.5f, y * 1.5f, 0.75f}, host::kNoCaster}; }

using Words = std::vector<uint32_t>;

/// visited: faults `endless`; deepest: faults `outside` (see core_device.cmake).
void expect(const HandTree& tree, const std::vector<OracleSample>& samples, const Words& want, const Words& endless, const Words& outside) {
    for (const Case& one : cases()) {
        const HandAnswer answer = tree.ask(samples, one.query, &one.shader);
        EXPECT_EQ(answer.visibility, want) << one.query.name;
        EXPECT_EQ(Words(answer.visited.begin(), answer.visited.begin() + std::ssize(samples)), endless) << one.query.name;
        EXPECT_EQ(Words(answer.deepest.begin(), answer.deepest.begin() + std::ssize(samples)), outside) << one.query.name;
    }
}

TEST(Debug, NothingIsFoundInATreeThatIsRight) {
    for (const auto precision : {Precision::published, Precision::conservative, Precision::certified}) {
        HandTree tree(precision);
        const uint32_t root = tree.add(target(0, 0)), child = tree.add(target(0.25f, 0));
        tree.positive(4 * root + 1, child, GNO_TOP_NONE);
        expect(tree, {behind(0, 0), behind(0.25f, 0), behind(0, 0.25f)}, {kDark, kDark, kLit}, {0, 0, 0}, {0, 0, 0});
    }
}

// A volume hangs in its own positive child: samples on that side go round in circles.
TEST(Debug, ACircleEnds) {
    HandTree tree(Precision::certified);
    const uint32_t root = tree.add(target(0, 0));
    tree.positive(4 * root, root, GNO_TOP_NONE);
    expect(tree, {behind(0, 0), behind(0, -0.25f)}, {kDark, kUnknown}, {0, 1}, {0, 0});
}

TEST(Debug, AChildBeyondTheArrayIsNotLoaded) {
    HandTree tree(Precision::certified);
    const uint32_t root = tree.add(target(0, 0));
    tree.child(4 * root, 4u << 20);
    expect(tree, {behind(0, 0), behind(0, -0.25f)}, {kDark, kUnknown}, {0, 0}, {0, 1});
}

}  // namespace
}  // namespace gno
