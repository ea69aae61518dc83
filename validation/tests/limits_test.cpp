// SPDX-License-Identifier: MIT
// What each technique holds, as pure functions of a made-up device: no device, no buffer. And what `auto` makes of it.
#include <gtest/gtest.h>

#include <algorithm>

#include "glsl/clusters/passes.hpp"
#include "glsl/top/passes.hpp"
#include "host_min/app/effects.hpp"
#include "host_min/app/refusals.hpp"
#include "host_min/error.hpp"

namespace gno::host {
namespace {

const std::vector<std::string> kNone;

std::string over(const std::string& name, uint64_t triangles, const std::vector<std::string>& settings = {}, const DeviceFacts& device = {}) {
    const Technique& technique = techniqueByName(name);
    return technique.overLimit(device, {triangles, 512, 512, false}, Settings(technique.info().settings, settings));
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Bytes of the largest array that a shader binds as storage.
uint64_t largest(const ArrayList& arrays) {
    uint64_t bytes = 0;
    for (const Array& array : arrays)
        if (array.usage & kUsageStorage) bytes = std::max(bytes, array.bytes);
    return bytes;
}

// By the lists of arrays themselves: one caster more, and an array passes the binding.
TEST(Limits, AreThoseOfTheArrays) {
    const uint64_t range = DeviceFacts{}.maxStorageBufferRange;
    const uint64_t clusters = clusterMostCasters(range), top = range / 64;
    EXPECT_EQ(clusters, 1198372u);
    EXPECT_LE(largest(clusterArrays(64, 64, clusters, {})), range);
    EXPECT_GT(largest(clusterArrays(64, 64, clusters + 1, {})), range);
    EXPECT_LE(largest(topArrays(top)), range);
    EXPECT_GT(largest(topArrays(top + 1)), range);
    for (const char* name : {"ptsv", "ptsv-2011"}) {
        EXPECT_EQ(over(name, clusters), "") << name;
        const std::string text = over(name, clusters + 1);
        EXPECT_TRUE(says(text, "1198373 triangles") && says(text, "1198372") && says(text, "maxStorageBufferRange") &&
                    says(text, "another technique"))
            << text;
    }
    for (const char* name : {"psv", "d-psv", "d-stackless", "d-hybrid", "forest", "light-grid"}) {
        EXPECT_EQ(over(name, top), "") << name;
        EXPECT_TRUE(says(over(name, top + 1), std::to_string(top))) << name;
    }
}

// Where a binding is no limit, a row of work groups is.
TEST(Limits, OfWorkGroups) {
    DeviceFacts large;
    large.maxStorageBufferRange = 0xFFFFFFFFu;
    const uint64_t most = 65535ull * 64;
    for (const auto& technique : techniques()) {
        const std::string& name = technique->info().name;
        if (name == "shadow-map" || name == "ray-query") continue;
        EXPECT_EQ(over(name, most, {}, large), "") << name;
        EXPECT_NE(over(name, most + 1, {}, large), "") << name;
    }
    EXPECT_TRUE(says(over("psv", 70000, {"group=1"}), "use at least 2"));
}

TEST(Limits, OfSizesAndSettings) {
    DeviceFacts small;
    small.maxImageDimension2D = 1024;
    EXPECT_TRUE(says(over("shadow-map", 1, {}, small), "--set map=2048"));
    EXPECT_EQ(over("shadow-map", 1, {"map=1024"}, small), "");
    const Technique& clusters = techniqueByName("ptsv");
    const Settings given(clusters.info().settings, std::vector<std::string>{"bounds=explicit"});
    EXPECT_TRUE(says(clusters.overLimit({}, {1, 8192, 8192, false}, given), "--set bounds=compact"));
    const Settings defaults(clusters.info().settings, kNone);
    EXPECT_EQ(clusters.overLimit({}, {1, 4096, 4096, false}, defaults), "");
    EXPECT_TRUE(says(clusters.overLimit({}, {1, 4096, 4096, true}, defaults), "--set materials=off"));
}

TEST(Auto, NeverPicksWhatWillRefuse) {
    Frame frame;
    frame.triangles.resize(10);
    EXPECT_EQ(chooseAutomatically(frame, Precision::certified).technique, &techniqueByName("forest"));
    const Choice without = chooseAutomatically(frame, Precision::certified, {.refused = {&techniqueByName("forest")}});
    EXPECT_EQ(without.technique, &techniqueByName("d-hybrid"));
    EXPECT_TRUE(says(without.why, "d-hybrid: forest would be better here, but it refused")) << without.why;

    frame.surfaces.resize(3);  // of casters that are not opaque
    EXPECT_EQ(chooseAutomatically(frame, Precision::certified).technique, &techniqueByName("ptsv"));
    ChoiceFacts facts;
    facts.device.subgroupBallot = false;
    const Choice opaque = chooseAutomatically(frame, Precision::certified, facts);
    EXPECT_EQ(opaque.technique, &techniqueByName("forest"));
    EXPECT_TRUE(says(opaque.why, "VK_SUBGROUP_FEATURE_BALLOT_BIT") && says(opaque.why, "taken for opaque")) << opaque.why;
    EXPECT_EQ(chooseAutomatically(frame, Precision::published, facts).technique, &techniqueByName("d-hybrid"));

    facts = {};
    frame.triangles.resize(clusterMostCasters(facts.device.maxStorageBufferRange) + 1);
    const Choice many = chooseAutomatically(frame, Precision::certified, facts);
    EXPECT_EQ(many.technique, &techniqueByName("forest"));
    EXPECT_TRUE(says(many.why, "1198372") && says(many.why, "taken for opaque")) << many.why;

    for (const auto& technique : techniques()) facts.refused.insert(technique.get());
    const Choice none = chooseAutomatically(frame, Precision::certified, facts);
    EXPECT_EQ(none.technique, nullptr);
    EXPECT_TRUE(says(none.why, "no technique holds this scene")) << none.why;
}

class RefusalsTest : public testing::Test {
protected:
    const Technique &first = techniqueByName("ptsv"), &second = techniqueByName("psv");
    const DeviceFacts device;
    Progress progress;
    Refusals refusals(Refusals::Asked asked) { return {asked, device, kNone, progress}; }
};

TEST_F(RefusalsTest, ALimitIsAFaultOfWhoWasNamed) {
    for (const auto asked : {Refusals::Asked::all, Refusals::Asked::automatically, Refusals::Asked::byName}) {
        Refusals some = refusals(asked);
        EXPECT_FALSE(some.holds(first, {2000000, 64, 64, false}));
        EXPECT_FALSE(some.holds(first, {1, 64, 64, false})) << "asked again";
        EXPECT_TRUE(some.holds(second, {2000000, 64, 64, false}));
        EXPECT_EQ(some.onlyLimits(), asked != Refusals::Asked::byName);
        if (asked == Refusals::Asked::byName)
            EXPECT_THROW(some.finish(), InputError);
        else
            EXPECT_NO_THROW(some.finish());
    }
}

TEST_F(RefusalsTest, WhatElseGoesWrongIsAFaultOfAll) {
    Refusals some = refusals(Refusals::Asked::all);
    EXPECT_TRUE(some.run(second, [] {}));
    EXPECT_FALSE(some.run(first, [] { throw LimitError("too many"); }));
    EXPECT_NO_THROW(some.finish());
    EXPECT_FALSE(some.run(second, [] { throw MemoryError("no memory left"); }));
    EXPECT_FALSE(some.run(techniqueByName("forest"), [] { throw std::bad_alloc(); }));
    EXPECT_FALSE(some.gone());
    try {
        some.finish();
        ADD_FAILURE() << "no fault";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "technique psv: no memory left; technique forest: out of memory: use a smaller --size or scene");
    }
}

TEST_F(RefusalsTest, ALostDeviceEndsTheRunAndAnInterruptPasses) {
    Refusals some = refusals(Refusals::Asked::all);
    EXPECT_FALSE(some.run(first, [] { throw vk::DeviceLostError("vkQueueSubmit2"); }));
    EXPECT_TRUE(some.gone());
    EXPECT_THROW(some.finish(), DeviceLost);
    Refusals other = refusals(Refusals::Asked::all);
    EXPECT_THROW((void)other.run(first, [] { throw Interrupted("interrupted"); }), Interrupted);
}

}  // namespace
}  // namespace gno::host
