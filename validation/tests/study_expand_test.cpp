// SPDX-License-Identifier: MIT
// From options to jobs: every technique and precision, what --vary and --best add, keys that are unique, words that come back; the search for a
// value.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "host_min/error.hpp"
#include "host_min/techniques/technique.hpp"
#include "validation/study/best.hpp"
#include "validation/study/expand.hpp"
#include "validation/study/peer.hpp"
#include "validation/study/presets.hpp"
#include "validation/tests/scene_builder.hpp"

namespace gno::study {
namespace {

std::vector<Variant> variants(const std::string& line) { return variantsOf(parseSweepLine(line)); }

size_t registered() {
    size_t count = 0;
    for (const auto& technique : host::techniques()) count += technique->info().precisions.size();
    for (const auto& peer : peers()) count += peer->precisions().size();
    return count;
}

std::string complaint(const std::string& line) {
    try {
        variants(line);
    } catch (const host::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Variants, AllIsEveryTechniqueAtEveryPrecision) { EXPECT_EQ(variants("x.glb").size(), registered()); }

TEST(Variants, VaryAddsToTechniquesThatKnowTheKey) {
    const auto with = variants("x.glb --technique d-hybrid,d-stackless --precision certified --vary stack=4,8,12");
    std::vector<std::string> keys;
    for (const Variant& variant : with) keys.push_back(variant.key());
    EXPECT_EQ(keys, (std::vector<std::string>{
                        "d-stackless certified seed=1 stage=compute group=64", "d-hybrid certified stack=12 seed=1 stage=compute group=64",
                        "d-hybrid certified stack=4 seed=1 stage=compute group=64", "d-hybrid certified stack=8 seed=1 stage=compute group=64"}));
    EXPECT_TRUE(with[1].varied({}).empty());
    EXPECT_EQ(with[2].varied({}), std::vector<std::string>{"stack"});
    EXPECT_EQ(with[2].settings({})["stack"], 4);
}

TEST(Variants, OneEntryIsAllCombinationsAndSeveralAreNot) {
    EXPECT_EQ(variants("x.glb --technique psv --precision certified --vary stack=4,8:group=32,128").size(), 1u + 4u);
    EXPECT_EQ(variants("x.glb --technique psv --precision certified --vary stack=4,8 --vary group=32,128").size(), 1u + 2u + 2u);
}

TEST(Variants, BestAddsARowBesideEachThatLeavesTheKeyOpen) {
    const auto with = variants("x.glb --technique psv --precision certified --vary stack=4 --vary group=32 --best stack");
    ASSERT_EQ(with.size(), 5u);  // default, best; stack=4; group=32, best
    EXPECT_EQ(std::count_if(with.begin(), with.end(), [](const Variant& v) { return v.bestOf == "stack"; }), 2);
    EXPECT_NE(with[1].key().find("stack=best"), std::string::npos) << with[1].key();
    EXPECT_EQ(with[1].settings("7")["stack"], 7);
}

TEST(Variants, WhatNobodyKnowsIsRefusedWithAListOfWhatIsKnown) {
    EXPECT_NE(complaint("x.glb --technique nothing").find("there are psv, d-psv"), std::string::npos);
    EXPECT_NE(complaint("x.glb --precision half").find("there are published"), std::string::npos);
    EXPECT_NE(complaint("x.glb --technique psv --vary nothing=1").find("known here: stack, seed"), std::string::npos);
    EXPECT_NE(complaint("x.glb --technique psv --best nothing").find("known here: stack, seed"), std::string::npos);
    EXPECT_NE(complaint("x.glb --technique psv --vary stack=1000").find("must be 1..64"), std::string::npos);
    EXPECT_NE(complaint("x.glb --technique psv --vary stack"), "");
    EXPECT_NE(complaint("x.glb --technique psv --set stack=4 --vary stack=8"), "");
}

TEST(Options, WordsGiveTheSameOptionsAgain) {
    const SweepOptions options = parseSweepLine(
        "a.glb b.glb --technique psv,ptsv --size 64x36,128x72 --light all --frame 0..8..2 --cull none,all --set seed=3 "
        "--vary stack=4,8:group=32 --vary split=off --best stack --vary-scene fuzzy=4000,8000 --repeat 2");
    EXPECT_EQ(commandWords(parseSweepLine(commandWords(options))), commandWords(options));
    EXPECT_EQ(options.vary.size(), 2u);
}

TEST(Options, FramesAndSizes) {
    EXPECT_EQ(framesOf("3"), std::vector<uint32_t>{3});
    EXPECT_EQ(framesOf("0..6..3"), (std::vector<uint32_t>{0, 3, 6}));
    EXPECT_EQ(framesOf("0..7..3"), (std::vector<uint32_t>{0, 3, 6}));
    for (const char* bad : {"", "x", "3..1", "1..2..0", "1..2..3..4", "-1", "1..", "99999999999"})
        EXPECT_THROW(framesOf(bad), host::InputError) << bad;
    for (const char* bad : {"", "64", "64x", "x64", "64x36x2", "ax b"}) EXPECT_THROW(sizeOf(bad), host::InputError) << bad;
}

TEST(Presets, KeysAreUniqueAndNoGroupIsMeasuredTwice) {
    const host::test::TemporaryFolder folder;
    std::filesystem::current_path(GNOMON_ROOT);  // the presets name the shipped scenes from there
    for (const Preset preset : {Preset::tiny, Preset::shortStudy}) {
        SceneShelf shelf(folder.path());
        std::vector<std::string> leftOut;
        std::set<std::string> groups, jobs;
        std::set<std::pair<std::string, std::string>> ladder;
        for (const SweepOptions& sweep : presetSweeps(preset, leftOut)) {
            for (const GroupJobs& one : expand(sweep, shelf)) {
                EXPECT_TRUE(groups.insert(one.group.key()).second) << one.group.key();
                for (const Variant& variant : one.variants) {
                    EXPECT_TRUE(jobs.insert(jobKey(one.group, variant)).second) << jobKey(one.group, variant);
                    ladder.emplace(variant.technique, variant.precision);
                }
            }
        }
        EXPECT_EQ(ladder.size(), registered());
    }
}

TEST(Presets, TheFullStudysOptionsAreGood) {
    std::vector<std::string> leftOut;
    for (const SweepOptions& sweep : presetSweeps(Preset::full, leftOut)) EXPECT_GE(variantsOf(sweep).size(), registered());
}

/// The least |log2(value / wanted)| is best; every value is a whole number.
std::string found(const host::SettingInfo& info, double wanted) {
    return bestValue(info, [&](const std::string& text) {
        EXPECT_EQ(text.find('.'), std::string::npos) << text;
        return uint64_t(1000 * std::abs(std::log2((std::stod(text) + 1) / (wanted + 1))));
    });
}

TEST(Best, FindsTheValleyOfARangeOverManyDecades) {
    const host::SettingInfo info{"bias", "", 0, 1000000, {}, "16"};
    for (const double wanted : {0.0, 3.0, 47.0, 900.0, 20000.0, 1000000.0}) {
        const double value = std::stod(found(info, wanted));
        EXPECT_LE(std::abs(std::log2((value + 1) / (wanted + 1))), 0.35) << "wanted " << wanted << ", got " << value;
    }
}

TEST(Best, FindsTheValleyOfAShortRange) {
    const host::SettingInfo info{"stack", "", 1, 64, {}, "32"};
    for (const double wanted : {1.0, 9.0, 31.0, 64.0}) EXPECT_NEAR(std::stod(found(info, wanted)), wanted, 1 + wanted / 8);
}

TEST(Best, TriesEveryWord) {
    const host::SettingInfo info{"fit", "", 0, 0, {"uniform", "focused", "other"}, "uniform"};
    EXPECT_EQ(bestValue(info, [](const std::string& word) { return word == "other" ? 1u : 5u; }), "other");
}

TEST(Best, TheDefaultStaysWhenNothingIsBetter) {
    EXPECT_EQ(bestValue({"bias", "", 0, 1000000, {}, "16"}, [](const std::string&) { return 3u; }), "16");
    EXPECT_EQ(bestValue({"fit", "", 0, 0, {"a", "b"}, "b"}, [](const std::string&) { return 3u; }), "b");
}

}  // namespace
}  // namespace gno::study
