// SPDX-License-Identifier: MIT
// What build() and StructureCache promise of any structure (host_min/techniques/structure.hpp), held on one that records nothing and takes notes;
// and that the state of real techniques, which outlives frames, never shows in a mask.
#include "host_min/techniques/structure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "host_min/error.hpp"
#include "host_min/scene/scene.hpp"
#include "host_min/techniques/technique.hpp"
#include "validation/support/device_test.hpp"

namespace gno::host {
namespace {

struct Notes {
    std::vector<std::string> calls;
    uint32_t incomplete = 0;  ///< so many builds lack room
    uint32_t segments = 1;
};

class Noted final : public Structure {
public:
    explicit Noted(Notes& notes) : notes_(notes) {}
    void prepare(const FrameInputs&) override { notes_.calls.push_back("prepare"); }
    [[nodiscard]] uint32_t segments() const override { return notes_.segments; }
    void record(Recording& recording, uint32_t segment) const override {
        notes_.calls.push_back("record " + std::to_string(segment));
        recording.beginPass("part " + std::to_string(segment));
        recording.endPass();
    }
    void between(uint32_t segment) override {
        notes_.calls.push_back("between " + std::to_string(segment));
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    void count() override { notes_.calls.push_back("count"); }
    [[nodiscard]] bool read() override {
        notes_.calls.push_back("read");
        if (notes_.incomplete == 0) return true;
        --notes_.incomplete;
        return false;
    }

private:
    Notes& notes_;
};

class StructureTest : public testing::Test {
protected:
    FrameInputs inputs() { return FrameInputs(test::passes(), frame_, samples_); }
    Frame frame_;
    std::array<OracleSample, 1> samples_{OracleSample{{0, 0, 0}, kNoCaster}};
    Notes notes_;
};

using Calls = std::vector<std::string>;

TEST_F(StructureTest, IsPreparedOnceAndRecordedForTheWarmUpAndEveryRepeat) {
    const FrameInputs in = inputs();
    Noted structure(notes_);
    build(structure, in, {.repeat = 2, .warmUp = true, .counters = true});
    EXPECT_EQ(notes_.calls, (Calls{"prepare", "record 0", "read", "record 0", "record 0", "count"}));
    EXPECT_EQ(structure.waits(), 0u);
    ASSERT_EQ(structure.passes().size(), 2u);
    EXPECT_EQ(structure.passes()[1].name, "part 0");
}

TEST_F(StructureTest, WithoutWarmUpTheFirstRunIsTheMeasuredOne) {
    const FrameInputs in = inputs();
    Noted structure(notes_);
    build(structure, in, {.repeat = 1, .warmUp = false, .counters = false});
    EXPECT_EQ(notes_.calls, (Calls{"prepare", "record 0", "read"}));
}

TEST_F(StructureTest, WaitsOfTheHostAreCountedAndTimed) {
    const FrameInputs in = inputs();
    notes_.segments = 3;
    Noted structure(notes_);
    build(structure, in, {.repeat = 1, .warmUp = false, .counters = false});
    EXPECT_EQ(notes_.calls, (Calls{"prepare", "record 0", "between 0", "record 1", "between 1", "record 2", "read"}));
    EXPECT_EQ(structure.waits(), 2u);
    ASSERT_EQ(structure.passes().size(), 5u);
    EXPECT_EQ(structure.passes().back().name, "host_wait");
    EXPECT_GE(structure.passes().back().ms, 39);  // it slept twice
}

TEST_F(StructureTest, APoolThatIsTooSmallIsEnlargedThreeTimesAtMost) {
    const FrameInputs in = inputs();
    notes_.incomplete = 3;
    Noted structure(notes_);
    build(structure, in, {.repeat = 1, .warmUp = false, .counters = false});
    EXPECT_EQ(structure.reruns(), 3u);
    EXPECT_EQ(std::count(notes_.calls.begin(), notes_.calls.end(), "prepare"), 4);
    notes_.incomplete = 4;
    EXPECT_THROW(build(structure, in, {.repeat = 1, .warmUp = false, .counters = false}), InputError);
}

TEST_F(StructureTest, TheCacheBuildsOnceAFrameAndKeepsTheState) {
    const FrameInputs in = inputs();
    StructureCache cache;
    int made = 0;
    const auto make = [&] { return ++made, std::make_unique<Noted>(notes_); };
    const Structure* first = &cache.get<Structure>("a", in, {.warmUp = false, .counters = false}, make);
    EXPECT_EQ(&cache.get<Structure>("a", in, {.warmUp = false, .counters = false}, make), first);
    EXPECT_EQ(std::count(notes_.calls.begin(), notes_.calls.end(), "prepare"), 1);
    cache.nextFrame();
    EXPECT_EQ(&cache.get<Structure>("a", in, {.warmUp = false, .counters = false}, make), first);
    EXPECT_EQ(std::count(notes_.calls.begin(), notes_.calls.end(), "prepare"), 2);
    EXPECT_EQ(made, 1);
    (void)cache.get<Structure>("b", in, {.warmUp = false, .counters = false}, make);
    EXPECT_EQ(made, 2);
}

// A frame alone has the mask that it has behind others, whatever those taught the state (pools, resolutions).
TEST(StateOfTechniques, AFrameAloneEqualsTheSameFrameOfARange) {
    const SceneFile file = SceneFile::load(GNOMON_SOURCE_DIR "/scenes/show_stairs.glb");
    constexpr std::array<uint32_t, 2> kFrames{0, 40};
    for (const char* name : {"d-hybrid", "forest", "light-bvh", "light-grid", "shadow-map"}) {
        Technique* technique = &techniqueByName(name);
        const TechniqueInfo& info = technique->info();
        if (!missingFor(info, test::passes().device().facts()).empty()) continue;
        SCOPED_TRACE(info.name);
        const Settings settings(info.settings, std::vector<std::string>());
        const RunOptions options{.precision = info.precisions.back(), .counters = false, .warmUp = false};
        StructureCache kept;
        for (const uint32_t number : kFrames) {
            const Frame frame = file.evaluate(number, 0);
            FrameInputs drawn(test::passes(), frame, 48, 32);
            drawn.setLight(frame.lights.at(1).homogeneous, Cull::none);
            kept.nextFrame();
            StructureCache fresh;
            EXPECT_EQ(technique->run(drawn, kept, settings, options).visibility, technique->run(drawn, fresh, settings, options).visibility)
                << "frame " << number;
        }
    }
}

}  // namespace
}  // namespace gno::host
