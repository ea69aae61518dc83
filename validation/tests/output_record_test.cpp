// SPDX-License-Identifier: MIT
// The record's keys are a contract; the table's ratios are arithmetic.
#include <gtest/gtest.h>
#include <unistd.h>
#include <algorithm>

#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

#include "host_min/error.hpp"
#include "host_min/output/record.hpp"
#include "host_min/output/table.hpp"

using namespace gno::host;
using nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

Record sample(const std::string& technique, double build, double query) {
    Record record;
    record.scene = "scenes/fence/fence.glb";
    record.technique = technique;
    record.precision = "certified";
    record.settings = {{"stack", 12}, {"bounds", "explicit"}};
    record.device = {"llvmpipe", "Mesa 25.0.7", 8};
    record.size = {512, 256};
    record.triangles = 1000;
    record.casters = 900;
    record.samples = 2000;
    record.inShadow = 500;
    record.unknown = 7;
    record.passes = {{"top_build", build}, {"top_query", query}};
    record.bytes = {{"tree", 16777216}};
    record.counters = {123000, 9, 1, 4, 2, 3, {}};
    record.effects = {"point_light"};
    return record;
}

std::vector<std::string> keys(const ordered_json& object) {
    std::vector<std::string> names;
    for (const auto& item : object.items()) names.push_back(item.key());
    return names;
}

using Names = std::vector<std::string>;

std::string cell(const std::vector<std::vector<std::string>>& cells, std::size_t row, const std::string& column) {
    for (std::size_t i = 0; i < cells[0].size(); ++i)
        if (cells[0][i] == column) return cells[row][i];
    return "no such column: " + column;
}

}  // namespace

TEST(OutputRecord, HasTheKeysOfTheContractInTheirOrder) {
    Record record = sample("d-hybrid", 12.3, 45.6);
    Names top = {"schema",  "scene",  "frame",    "animation", "light",    "technique",        "precision", "settings",
                 "device",  "size",   "grid",     "triangles", "casters",  "taken_for_opaque", "samples",   "in_shadow",
                 "unknown", "passes", "total_ms", "bytes",     "counters", "host_waits",       "reruns",    "effects"};
    EXPECT_EQ(keys(ordered_json::parse(toJsonLine(record))), top);
    record.check = RecordCheck{2000, 3, 2, 1, 0, 5};
    record.floorMs = 7.5;
    top.insert(std::find(top.begin(), top.end(), "bytes"), "floor_ms");
    top.insert(top.end() - 1, "check");
    const std::string line = toJsonLine(record);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    const ordered_json json = ordered_json::parse(line);
    EXPECT_EQ(keys(json), top);
    EXPECT_EQ(keys(json["device"]), (Names{"name", "driver", "subgroup"}));
    EXPECT_EQ(keys(json["passes"][1]), (Names{"name", "ms"}));
    EXPECT_EQ(keys(json["counters"]), (Names{"visited_nodes", "max_stack", "stack_overflows", "exact_calls", "dropped", "test_and_set"}));
    EXPECT_EQ(keys(json["check"]), (Names{"checked", "wrong", "leaks", "false_dark", "self", "witness"}));
    EXPECT_EQ(json["schema"], 2);
    EXPECT_EQ(json["size"], (ordered_json{512, 256}));
    EXPECT_EQ(json["in_shadow"], 500);
    EXPECT_EQ(json["unknown"], 7);
    EXPECT_TRUE(json["animation"].is_null());
    EXPECT_EQ(json["taken_for_opaque"], 0);
    EXPECT_EQ(json["settings"]["stack"], 12);
    EXPECT_EQ(json["passes"][0]["name"], "top_build");
    EXPECT_DOUBLE_EQ(json["total_ms"].get<double>(), 57.9);
    EXPECT_DOUBLE_EQ(json["floor_ms"].get<double>(), 7.5);
    EXPECT_EQ(json["bytes"]["tree"], 16777216);
    EXPECT_EQ(json["counters"]["test_and_set"], 3);
    EXPECT_EQ(json["check"]["false_dark"], 1);
    EXPECT_EQ(json["check"]["witness"], 5);
    EXPECT_EQ(json["effects"], ordered_json::array({"point_light"}));
}

TEST(OutputRecord, EmptyPartsStayObjectsAndLists) {
    const ordered_json json = ordered_json::parse(toJsonLine(Record{}));
    EXPECT_TRUE(json["settings"].is_object());
    EXPECT_TRUE(json["bytes"].is_object());
    EXPECT_TRUE(json["passes"].is_array());
    EXPECT_TRUE(json["effects"].is_array());
    EXPECT_FALSE(json.contains("check"));
    Record more = sample("zpass", 0, 1);
    more.counters.more = {{"quads", 77}};
    EXPECT_EQ(toJson(more)["counters"]["quads"], 77);
    EXPECT_EQ(toJson(more)["counters"].size(), 7u);
}

TEST(OutputRecord, OnlyFiniteNumbersAndAnyText) {
    Record record = sample("psv", 1, std::numeric_limits<double>::infinity());
    EXPECT_THROW((void)toJsonLine(record), std::invalid_argument);
    record = sample("psv", 1, 1);
    record.floorMs = std::numeric_limits<double>::infinity();
    EXPECT_THROW((void)toJsonLine(record), std::invalid_argument);
    record = sample("psv", 1, 1);
    record.settings["bias"] = std::numeric_limits<double>::infinity();
    EXPECT_THROW((void)toJsonLine(record), std::invalid_argument);
    record = sample("psv", 1, 1);
    record.scene = "bad \xFF\n\" name";
    EXPECT_EQ(ordered_json::parse(toJsonLine(record))["scene"], "bad \xEF\xBF\xBD\n\" name");
}

// As of a device without time stamps.
TEST(OutputRecord, AMissingTimeIsNullAndADash) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    std::vector<Record> records{sample("psv", kNone, kNone), sample("d-psv", 1, 2)};
    records[0].floorMs = kNone;
    const ordered_json json = toJson(records[0]);
    EXPECT_TRUE(json["total_ms"].is_null());
    EXPECT_TRUE(json["floor_ms"].is_null());
    for (const ordered_json& pass : json["passes"]) EXPECT_TRUE(pass["ms"].is_null());
    const auto cells = tableCells(records);
    for (const char* column : {"build ms", "query ms", "total ms", "x fastest", "x floor"}) EXPECT_EQ(cell(cells, 1, column), "-") << column;
    EXPECT_EQ(cell(cells, 2, "x fastest"), "1.00");
}

TEST(OutputRecord, AFileIsOneObjectALine) {
    const fs::path path = fs::temp_directory_path() / ("gnomon_output_record_" + std::to_string(::getpid()) + ".json");
    const std::vector<Record> records = {sample("psv", 1, 2), sample("d-psv", 1, 1)};
    writeRecords(path, records);
    writeRecords(path, records);  // replaces
    std::ifstream file(path);
    Names techniques;
    for (std::string line; std::getline(file, line);) techniques.push_back(ordered_json::parse(line)["technique"]);
    fs::remove(path);
    EXPECT_EQ(techniques, (Names{"psv", "d-psv"}));
    EXPECT_THROW(writeRecords("/dev/full", records), RoomError);
}

TEST(OutputTable, Ratios) {
    std::vector<Record> records = {sample("psv", 10, 30), sample("d-psv", 10, 6)};
    records[0].floorMs = 8;
    records[1].samples = 0;
    auto cells = tableCells(records);
    ASSERT_EQ(cells.size(), 3u);
    EXPECT_EQ(cells[0].size(), 13u);
    EXPECT_EQ(cell(cells, 1, "unknown"), "7");
    for (Record& record : records) record.unknown = 0;
    cells = tableCells(records);
    EXPECT_EQ(cells[0].size(), 12u) << "a column that has nothing to say is left out";
    records[1].takenForOpaque = 5;
    cells = tableCells(records);
    EXPECT_EQ(cell(cells, 1, "taken as opaque"), "0");
    EXPECT_EQ(cell(cells, 2, "taken as opaque"), "5");
    EXPECT_EQ(cell(cells, 1, "in shadow %"), "25.0");
    EXPECT_EQ(cell(cells, 1, "visited/sample"), "61.5");
    EXPECT_EQ(cell(cells, 1, "max stack"), "9");
    EXPECT_EQ(cell(cells, 1, "overflows"), "1");
    EXPECT_EQ(cell(cells, 1, "build ms"), "10.00");
    EXPECT_EQ(cell(cells, 1, "query ms"), "30.00");
    EXPECT_EQ(cell(cells, 1, "total ms"), "40.00");
    EXPECT_EQ(cell(cells, 1, "x fastest"), "2.50");
    EXPECT_EQ(cell(cells, 2, "x fastest"), "1.00");
    EXPECT_EQ(cell(cells, 1, "x floor"), "5.0");
    EXPECT_EQ(cell(cells, 2, "x floor"), "-");
    EXPECT_EQ(cell(cells, 2, "visited/sample"), "-");
    records[1].check = RecordCheck{2000, 3, 2, 1, 0, 5};
    cells = tableCells(records);
    EXPECT_EQ(cell(cells, 1, "wrong"), "-");
    EXPECT_EQ(cell(cells, 2, "wrong"), "3");
    EXPECT_EQ(cell(cells, 2, "leaks"), "2");
    EXPECT_EQ(cell(cells, 2, "false dark"), "1");
}

TEST(OutputTable, BuildPassesAreTold) {
    for (const char* name : {"build", "top_build", "top_setup", "cluster_build", "setup_volumes"}) EXPECT_TRUE(isBuildPass(name)) << name;
    for (const char* name : {"top_query", "rebuilding", "traverse", "merge", ""}) EXPECT_FALSE(isBuildPass(name)) << name;
}

TEST(OutputTable, ColumnsAreAlignedAndFramesAreApart) {
    std::vector<Record> records = {sample("psv", 10, 30), sample("d-stackless", 100, 6.25), sample("psv", 1, 1)};
    records[2].frame = 7;
    const std::string text = formatTable(records, false);
    EXPECT_EQ(text.find('\033'), std::string::npos);
    EXPECT_NE(formatTable(records, true).find('\033'), std::string::npos);
    Names lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    ASSERT_EQ(lines.size(), 8u);  // title, names, two rows, empty, title, names, one row
    EXPECT_NE(lines[0].find("frame 0"), std::string::npos);
    EXPECT_NE(lines[5].find("frame 7"), std::string::npos);
    const auto end = [&](std::size_t line, const std::string& part) { return lines[line].find(part) + part.size(); };
    EXPECT_EQ(end(1, "query ms"), end(2, "30.00"));
    EXPECT_EQ(end(1, "query ms"), end(3, "6.25"));
    EXPECT_EQ(lines[1].find("precision"), lines[2].find("certified"));
    EXPECT_EQ(formatTable({}, false), "");
}
