// SPDX-License-Identifier: MIT
// One GLSL text, two compilers: a device that works through its invocations one by one, and the CPU, build the same TOP tree to the bit and visit
// the same nodes of it. Whatever is proved of the text on the CPU (mutants, fuzzing) thus speaks of the device, too.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

#include "validation/support/device_test.hpp"
#include "validation/support/top_on_cpu_check.hpp"
#include "validation/tests/oracle_cases.hpp"
#include "validation/tests/top_structure.hpp"

namespace gno {
namespace {

using host::Precision;

// Before the driver is loaded: one thread, so that work groups of one invocation run in their order.
[[maybe_unused]] const int kOneThread = setenv("LP_NUM_THREADS", "1", 1);

constexpr uint32_t kSeed = 1871;
constexpr uint32_t kOrder = 5;
constexpr uint kFlushed = 4;  // lavapipe flushes denormals

std::vector<GnoCaster> castersOf(const host::cases::HardCase& c) {
    std::vector<GnoCaster> casters;
    for (const host::Triangle& t : c.triangles) casters.push_back({t.a, t.b, t.c});
    return casters;
}

template <class T>
std::string firstDifference(const char* what, const std::vector<T>& device, const std::vector<T>& cpu) {
    if (device.size() < cpu.size()) return fmt::format("{}: {} on the device, {} on the CPU", what, device.size(), cpu.size());
    for (size_t i = 0; i < cpu.size(); ++i) {
        if (std::memcmp(&device[i], &cpu[i], sizeof(T)) == 0) continue;
        uint32_t d[4], c[4];
        static_assert(sizeof(T) == sizeof d);
        std::memcpy(d, &device[i], sizeof d);
        std::memcpy(c, &cpu[i], sizeof c);
        return fmt::format("{} of node {}: {:08x} {:08x} {:08x} {:08x} on the device, {:08x} {:08x} {:08x} {:08x} on the CPU", what, i, d[0], d[1],
                           d[2], d[3], c[0], c[1], c[2], c[3]);
    }
    return {};
}

void expectSameTree(const host::cases::HardCase& c, const cpu::TopTree& tree, Precision precision) {
    host::Frame frame;
    frame.triangles = c.triangles;
    frame.closed.assign(c.triangles.size(), 0);
    host::FrameInputs inputs(test::passes(), frame, c.samples);
    inputs.setLight(c.light, host::Cull::none);
    const auto device = host::built<host::TopTree>(inputs, TopOptions{.precision = uint32_t(precision), .seed = kOrder, .groupSize = 1},
                                                   {.warmUp = false, .counters = false});
    const test::TopBuffers buffers = test::download(device);
    EXPECT_EQ(firstDifference("planes", buffers.planes, tree.planes()), "");
    EXPECT_EQ(firstDifference("links", buffers.links, tree.links()), "");
    EXPECT_EQ(buffers.header.root, tree.header().root);
    EXPECT_EQ(buffers.header.casterCount, tree.header().casterCount);
}

void expectSameVisits(const host::cases::HardCase& c, cpu::TopTree& tree, Precision precision) {
    const test::Scene scene{c.triangles, {}, c.light, c.samples};
    const std::vector<std::string> names(cpu::kTopQueryNames.begin(), cpu::kTopQueryNames.end());
    const std::vector<std::string> settings{"group=1", fmt::format("seed={}", kOrder)};
    const auto results = test::runAll(scene, names, precision, settings);
    for (size_t q = 0; q < names.size(); ++q) {
        size_t different = 0, first = 0;
        for (size_t i = c.samples.size(); i-- > 0;) {
            const cpu::FloatMode mode(kFlushed);
            const cpu::TopAnswer answer = tree.ask(cpu::kTopQueries[q], {c.samples[i].position, c.samples[i].own});
            const uint32_t visibility = answer.inShadow ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT;
            if (results[q].visibility.at(i) == visibility && results[q].visitedNodes.at(i) == answer.visitedNodes &&
                results[q].deepestStack.at(i) == answer.deepestStack)
                continue;
            ++different;
            first = i;
        }
        EXPECT_EQ(different, 0u) << names[q] << ", sample " << first << ": " << results[q].visitedNodes[first] << " nodes on the device";
    }
}

void expectSame(Precision precision) {
    std::printf("seed %u\n", kSeed);
    const auto tree = cpu::makeTopTree("plain");
    for (const auto& c : host::cases::hardCases(kSeed, 256)) {
        if (c.triangles.empty() || !c.isCaster.empty()) continue;  // nothing to build; casters left out are top_build_test's
        SCOPED_TRACE(fmt::format("{}, {}", c.name, name(precision)));
        {
            const cpu::FloatMode mode(kFlushed);
            const uint count = uint(c.triangles.size());
            tree->build(castersOf(c), c.light, uint(precision), cpu::insertionOrder(count, kOrder));
        }
        expectSameTree(c, *tree, precision);
        expectSameVisits(c, *tree, precision);
    }
}

// The comparison above can fail.
TEST(TopOnCpu, AnotherOrderIsAnotherTree) {
    const auto c = host::cases::hardCases(kSeed, 1).front();
    const auto tree = cpu::makeTopTree("plain");
    const auto build = [&](uint seed) {
        tree->build(castersOf(c), c.light, GNO_PRECISION_CERTIFIED, cpu::insertionOrder(uint(c.triangles.size()), seed));
        return tree->links();
    };
    const auto links = build(kOrder);
    EXPECT_NE(firstDifference("links", links, build(kOrder + 1)), "");
    EXPECT_EQ(firstDifference("links", links, build(kOrder)), "");
}

TEST(TopOnCpu, Published) { expectSame(Precision::published); }
TEST(TopOnCpu, Conservative) { expectSame(Precision::conservative); }
TEST(TopOnCpu, Certified) { expectSame(Precision::certified); }

}  // namespace
}  // namespace gno
