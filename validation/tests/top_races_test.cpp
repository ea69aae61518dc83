// SPDX-License-Identifier: MIT
// The build has no lock and no fence: whatever the driver's threads do, each tree holds every caster once or inside another, and answers alike.
// ctest runs this at 1, 2 and 8 threads of the driver (LP_NUM_THREADS). With one thread the same tree comes out, bit for bit, in another process
// too.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "validation/support/device_test.hpp"
#include "validation/tests/oracle_cases.hpp"
#include "validation/tests/top_structure.hpp"

namespace gno {
namespace {

using host::Precision;

constexpr uint32_t kSeed = 3001, kBuilds = 200;
constexpr std::array<uint32_t, 6> kGroups{64, 1, 32, 100, 256, 7};

const host::Frame& frame() {
    static const host::Frame made = [] {
        host::cases::Random random(kSeed);
        host::Frame result;
        while (result.triangles.size() < 3000) {
            const glm::dvec3 at = random.inCube(0.9);
            const auto corner = [&] { return host::cases::snap(at + random.inCube(0.1)); };
            const glm::vec3 a = corner(), b = corner(), c = corner();
            result.triangles.push_back({a, b, c});
        }
        result.closed.assign(result.triangles.size(), 0);
        return result;
    }();
    return made;
}

std::vector<host::OracleSample> samples() {
    host::cases::HardCase hard{"", {0.0625f, 0.875f, -0.125f, 1}, frame().triangles, {}, {}};
    host::cases::Random random(kSeed + 1);
    addSamples(hard, random, 2048);
    for (host::OracleSample& sample : hard.samples) sample.own = host::kNoCaster;
    return hard.samples;
}

constexpr glm::vec4 kLight(0.0625f, 0.875f, -0.125f, 1);

uint64_t hash(const test::TopBuffers& tree) {  // FNV-1a
    uint64_t value = 0xCBF29CE484222325ull;
    for (const std::byte byte : tree.bytes()) value = (value ^ uint64_t(byte)) * 0x100000001B3ull;
    return value;
}

uint64_t hashOfOneBuild() {
    const std::array sample{host::OracleSample{{0, 0, 0}, host::kNoCaster}};
    host::FrameInputs inputs(test::passes(), frame(), sample);
    inputs.setLight(kLight, host::Cull::none);
    return hash(test::download(host::built<host::TopTree>(inputs, TopOptions{.seed = 11}, {.warmUp = false, .counters = false})));
}

TEST(TopRaces, TwoHundredBuilds) {
    const auto asked = samples();
    host::FrameInputs inputs(test::passes(), frame(), asked);
    inputs.setLight(kLight, host::Cull::none);
    const host::OracleAnswer want = host::makeOracle()->ask({frame().triangles, {}, kLight, asked}, [](double) {});
    const std::vector<uint8_t> kept(frame().triangles.size(), 1);  // nothing is edge-on here
    ASSERT_EQ(inputs.casterCount(), kept.size());
    host::Technique& query = host::techniqueByName("d-hybrid");
    size_t least = SIZE_MAX, most = 0;
    for (uint32_t i = 0; i < kBuilds; ++i) {
        const uint32_t group = kGroups[i % kGroups.size()];
        const std::vector<std::string> settings{fmt::format("group={}", group), "seed=5"};
        host::StructureCache structures;
        host::TechniqueResult got = query.run(inputs, structures, host::Settings(query.info().settings, settings),
                                              {.precision = Precision::certified, .counters = false, .dump = true, .warmUp = false});
        got.visibility.resize(asked.size());
        ASSERT_EQ(test::compare(got, want).wrong, 0u) << "build " << i << ", group " << group;

        test::TopBuffers tree;
        for (const host::DumpedBuffer& buffer : got.dump) {
            const auto fill = [&](auto& list) {
                list.resize(buffer.bytes.size() / sizeof(list[0])), std::memcpy(list.data(), buffer.bytes.data(), buffer.bytes.size());
            };
            if (buffer.name == "planes") fill(tree.planes);
            if (buffer.name == "links") fill(tree.links);
            if (buffer.name == "header") std::memcpy(&tree.header, buffer.bytes.data(), sizeof tree.header);
        }
        const test::TopWalk walked = walk(tree, kept);
        ASSERT_EQ(walked.error, "") << "build " << i << ", group " << group;
        if (i % 8 == 0) {
            ASSERT_EQ(checkBounds(tree, walked, frame().triangles, kLight, true, 0), "") << "build " << i << ", group " << group;
        }
        least = std::min(least, walked.order.size());
        most = std::max(most, walked.order.size());
        for (uint32_t caster = 0; caster < kept.size() && i % 20 == 0; ++caster) {  // who is not in it lies inside a volume that is
            if (walked.reached[caster]) continue;
            const host::Triangle& t = frame().triangles[caster];
            const auto covers = [&](uint32_t other) {
                const host::Triangle& o = frame().triangles[other];
                const auto a = exact::fixed(o.a), b = exact::fixed(o.b), c = exact::fixed(o.c);
                for (const glm::vec3 v : {t.a, t.b, t.c})
                    if (!exact::inShadowOf(kLight, a, b, c, exact::fixed(v))) return false;
                return true;
            };
            ASSERT_TRUE(std::any_of(walked.order.begin(), walked.order.end(), covers)) << "build " << i << ": caster " << caster << " is lost";
        }
    }
    std::printf("%u builds, %zu to %zu of %zu casters in the tree, the others inside volumes\n", kBuilds, least, most, kept.size());
    EXPECT_GT(most, 0u);
}

// One thread of the driver runs one work group after the other: the insertion order is the permutation, and nothing else may matter.
TEST(TopRaces, OneThreadGivesOneTree) {
    const char* threads = std::getenv("LP_NUM_THREADS");
    const uint64_t mine = hashOfOneBuild();
    if (const char* file = std::getenv("GNOMON_TREE_HASH_FILE")) {  // the other process
        std::ofstream(file) << mine;
        return;
    }
    const std::filesystem::path path = std::filesystem::temp_directory_path() / fmt::format("gnomon_tree_{}", ::getpid());
    const std::string command = fmt::format("GNOMON_TREE_HASH_FILE='{}' '{}' --gtest_filter=TopRaces.OneThreadGivesOneTree > /dev/null",
                                            path.string(), std::filesystem::read_symlink("/proc/self/exe").string());
    ASSERT_EQ(std::system(command.c_str()), 0);
    uint64_t theirs = 0;
    std::ifstream(path) >> theirs;
    std::filesystem::remove(path);
    std::printf("tree %016llx here, %016llx in another process\n", (unsigned long long)mine, (unsigned long long)theirs);
    EXPECT_NE(theirs, 0u);
    if (threads && std::string(threads) == "1") {
        EXPECT_EQ(mine, theirs);
        EXPECT_EQ(mine, hashOfOneBuild());
    }
}

}  // namespace
}  // namespace gno
