// SPDX-License-Identifier: MIT
// The rows of a sweep: complete, equal to what `gnomon shade` says, timed in turns, wrong where the published algorithms are known to be.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/tests/study_child.hpp"

namespace gno::test {
namespace {

namespace fs = std::filesystem;
using study::Row;

const char* const kRoom = "room:12 --size 96x54 --technique psv,d-stackless,ptsv --repeat 3";

std::vector<double> times(const Row& list) { return list.get<std::vector<double>>(); }

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

TEST_F(Study, RowsAreCompleteAndTimedInTurns) {
    const Outcome outcome = sweep(kRoom, {{{"LP_NUM_THREADS", "1"}, {"GNOMON_VALIDATE", "1"}}, {}});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "") << "no bar in a pipe";
    const auto all = rows();
    ASSERT_EQ(all.size(), 9u);
    double least = HUGE_VAL;
    size_t published = 0;
    for (const Row& row : all) {
        SCOPED_TRACE(row["job"].get<std::string>());
        EXPECT_EQ(row["group"], "room:12 camera=0 frame=0 light=0 cull=none 96x54");
        EXPECT_EQ(row["run"], all[0]["run"]);
        EXPECT_EQ(row["name"], "room_12");
        EXPECT_EQ(row["generated"]["triangles"], 12);
        EXPECT_EQ(row["light_kind"], "point");
        EXPECT_EQ(row["casters"], 12);
        EXPECT_EQ(times(row["floor_ms"]), times(all[0]["floor_ms"])) << "one floor for all of a repeat";
        ASSERT_EQ(row["floor_ms"].size(), 3u);
        ASSERT_EQ(row["total_ms"].size(), 3u);
        std::vector<double> sums(3, 0);
        bool hasSetUp = false;
        for (const Row& pass : row["passes"]) {
            ASSERT_EQ(pass["ms"].size(), 3u);
            for (size_t i = 0; i < 3; ++i) sums[i] += pass["ms"][i].get<double>();
            if (pass["name"] != "caster_setup") continue;
            hasSetUp = true;
            EXPECT_EQ(pass["ms"], all[0]["passes"][0]["ms"]) << "shared by all of a repeat";
        }
        EXPECT_TRUE(hasSetUp);
        for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(row["total_ms"][i].get<double>(), sums[i], 1e-4);
        least = std::min(least, median(times(row["total_ms"])));
        const Row& check = row["check"];
        EXPECT_EQ(check["checked"], row["samples"]);
        EXPECT_EQ(check["leaks"].get<int>() + check["false_dark"].get<int>(), check["wrong"].get<int>());
        uint64_t inBins = 0;
        for (const Row& count : check["distance"]["samples"]) inBins += count.get<uint64_t>();
        EXPECT_EQ(inBins, check["wrong"].get<uint64_t>());
        EXPECT_EQ(check["distance"]["samples"].size(), check["distance"]["pixels"].size());
        if (row["precision"] == "certified") {
            EXPECT_EQ(check["wrong"], 0);
        }
        if (row["precision"] == "published" && row["technique"] == "psv") {
            ++published;
            EXPECT_GT(check["wrong"].get<int>(), 0) << "known to be wrong here";
            for (const char* key : {"shaded", "truth", "wrong"})
                EXPECT_TRUE(readFile(stage.out() / row["pictures"][key].get<std::string>()).ends_with("IEND\xAE\x42\x60\x82")) << key;
        }
    }
    EXPECT_EQ(published, 1u);
    size_t fastest = 0;
    for (const Row& row : all) {
        EXPECT_GT(row["ratio_to_floor"].get<double>(), 0);
        fastest += row["ratio_to_fastest"] == 1.0;
        if (row["ratio_to_fastest"] == 1.0) {
            EXPECT_DOUBLE_EQ(median(times(row["total_ms"])), least);
        }
    }
    EXPECT_EQ(fastest, 1u);
}

TEST_F(Study, EachVariantBuildsItsOwnStructure) {
    ASSERT_EQ(sweep("fuzzy:4000 --size 32x18 --technique psv,d-psv,d-stackless --precision certified --repeat 2").code, 0);
    std::set<std::vector<double>> builds;
    for (const Row& row : rows())
        for (const Row& pass : row["passes"])
            if (pass["name"] == "top_build") builds.insert(times(pass["ms"]));
    EXPECT_EQ(builds.size(), 3u) << "the same time twice: a structure was shared";
}

TEST_F(Study, CountersAreThoseOfGnomonShade) {
    ASSERT_EQ(sweep("fuzzy:4000 --size 64x36 --light 1 --technique d-hybrid,ptsv --repeat 1 --set stack=6 --cull hull").code, 0);
    const auto all = rows();
    ASSERT_EQ(all.size(), 6u);
    for (const Row& row : all) {
        SCOPED_TRACE(row["job"].get<std::string>());
        const bool hybrid = row["technique"] == "d-hybrid";
        const std::string command = "LP_NUM_THREADS=1 '" GNOMON_SHADE_PROGRAM "' shade '" + (stage.out() / "scenes" / "fuzzy_4000.glb").string() +
                                    "' --size 64x36 --light 1 --check --set cull=hull " + (hybrid ? "--set stack=6 " : "") + "--technique " +
                                    row["technique"].get<std::string>() + " --precision " + row["precision"].get<std::string>() + " --out '" +
                                    (stage.path() / "shade").string() + "' --json '" + (stage.path() / "shade.jsonl").string() +
                                    "' > /dev/null 2>&1";
        ASSERT_EQ(std::system(command.c_str()), 0) << command;
        const Row record = Row::parse(readFile(stage.path() / "shade.jsonl"));
        for (const char* key : {"counters", "bytes", "casters", "triangles", "samples", "in_shadow", "size", "device"})
            EXPECT_EQ(row[key], record[key]) << key;
        for (const char* key : {"checked", "wrong", "leaks", "false_dark", "self"}) EXPECT_EQ(row["check"][key], record["check"][key]) << key;
        for (const auto& [key, value] : row["settings"].items()) EXPECT_EQ(value, record["settings"][key]) << key;
    }
}

TEST_F(Study, TheBestValueIsARowOfItsOwn) {
    ASSERT_EQ(sweep("room:12 --size 32x18 --technique psv --precision published --best stack --repeat 1").code, 0);
    const auto all = rows();
    ASSERT_EQ(all.size(), 2u);
    EXPECT_FALSE(all[0].contains("best_of"));
    EXPECT_EQ(all[1]["best_of"], "stack");
    EXPECT_LE(all[1]["check"]["wrong"], all[0]["check"]["wrong"]);
    EXPECT_TRUE(all[1]["settings"]["stack"].is_number());
    EXPECT_EQ(all[1]["varied"], Row::array({"stack"}));
}

TEST_F(Study, CastersThatLetLightThroughAreCheckedBySums) {
    ASSERT_EQ(sweep("leaves:600 --size 48x27 --technique ptsv,psv --precision certified --repeat 1").code, 0);
    for (const Row& row : rows()) EXPECT_EQ(row["check"]["wrong"], 0) << row["job"];
}

TEST_F(Study, WhatTheDeviceCannotDoIsARowThatSaysSo) {
    // One invocation a work group: 70,000 triangles need more work groups than Vulkan promises.
    const Outcome outcome = sweep("fuzzy:70000 --size 16x9 --technique psv,ptsv --precision certified --vary group=1 --repeat 1");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("1 of them unavailable"), std::string::npos) << outcome.out;
    size_t unavailable = 0;
    for (const Row& row : rows()) {
        const bool gone = row["technique"] == "psv" && row["settings"]["group"] == 1;
        EXPECT_EQ(row.contains("unavailable"), gone) << row["job"];
        EXPECT_NE(row.contains("total_ms"), gone) << row["job"];
        if (gone) {
            EXPECT_NE(row["unavailable"].get<std::string>().find("work groups"), std::string::npos);
        }
        unavailable += gone;
    }
    EXPECT_EQ(unavailable, 1u);
    EXPECT_EQ(rows().size(), 3u);
}

}  // namespace
}  // namespace gno::test
