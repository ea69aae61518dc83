// SPDX-License-Identifier: MIT
// What the program writes: records by their contract, EXR layers by name, pictures, dumped buffers; and the commands that only tell.
#include <algorithm>
#include <cstring>
#include <numeric>
#include <variant>

#include "glsl/clusters/cluster.h"
#include "glsl/forest/cells.h"
#include "glsl/rivals/light_bvh.h"
#include "glsl/rivals/light_grid.h"
#include "glsl/top/node.h"
#include "host_min/output/exr.hpp"
#include "validation/tests/cli_child.hpp"

namespace gno::test {
namespace {

namespace fs = std::filesystem;
using host::test::Json;
using Names = std::set<std::string>;

const std::vector<std::string> kAll{"psv", "d-psv", "d-stackless", "d-hybrid", "ptsv", "ptsv-2011", "forest", "light-bvh", "light-grid"};

bool isTop(const std::string& technique) { return technique == "psv" || technique.starts_with("d-"); }
bool visitsNodes(const std::string& technique) { return isTop(technique) || technique == "forest" || technique.starts_with("light-"); }

Names keysOf(const Json& object) {
    Names keys;
    for (const auto& [key, value] : object.items()) keys.insert(key);
    return keys;
}

std::vector<Json> recordsOf(const fs::path& path) {
    std::vector<Json> records;
    for (const std::string& line : linesOf(readFile(path))) records.push_back(Json::parse(line));
    return records;
}

/// Visibility of one technique, per pixel: what the record counts.
std::vector<float> maskOf(const fs::path& exr, const std::string& channel) {
    return std::get<std::vector<float>>(host::readExr(exr).channels.at(channel));
}

/// Runs into stage.out() with a record and returns its lines.
std::vector<Json> shade(const Stage& stage, std::vector<std::string> arguments) {
    const fs::path record = stage.path() / "record.jsonl";
    arguments.insert(arguments.end(), {"--json", record.string()});
    expectDone(stage.shade(arguments));
    return fs::exists(record) ? recordsOf(record) : std::vector<Json>();
}

void expectContract(const Json& record, bool checked) {
    Names keys{"schema",   "scene",      "frame",     "light",   "technique", "precision",        "settings",
               "device",   "size",       "triangles", "casters", "animation", "taken_for_opaque", "grid",
               "samples",  "in_shadow",  "unknown",   "passes",  "total_ms",  "floor_ms",         "bytes",
               "counters", "host_waits", "reruns",    "effects"};
    if (checked) keys.insert("check");
    EXPECT_EQ(keysOf(record), keys);
    EXPECT_EQ(keysOf(record["device"]), (Names{"name", "driver", "subgroup"}));
    for (const char* counter : {"visited_nodes", "max_stack", "stack_overflows", "exact_calls", "dropped", "test_and_set"})
        EXPECT_TRUE(record["counters"].contains(counter)) << counter;
    double sum = 0;
    for (const Json& pass : record["passes"]) {
        EXPECT_EQ(keysOf(pass), (Names{"name", "ms"}));
        EXPECT_GE(pass["ms"].get<double>(), 0);
        sum += pass["ms"].get<double>();
    }
    EXPECT_FALSE(record["passes"].empty());
    EXPECT_NEAR(record["total_ms"].get<double>(), sum, 1e-3);
    EXPECT_EQ(record["schema"], 2);
    EXPECT_LE(record["in_shadow"].get<uint64_t>(), record["samples"].get<uint64_t>());
    if (!checked) return;
    EXPECT_EQ(keysOf(record["check"]), (Names{"checked", "wrong", "leaks", "false_dark", "self", "witness"}));
    EXPECT_EQ(record["check"]["checked"], record["samples"]);
    EXPECT_EQ(record["check"]["wrong"], 0) << record["technique"];
    EXPECT_EQ(record["check"]["self"], 0);
}

TEST(Shade, AllTechniquesAndLightsWithEverythingWritten) {
    const Stage stage;
    const std::string scene = stage.write("scene.glb", smallScene().glb());
    const auto records = shade(stage, {scene, "--technique", "all", "--light", "all", "--size", "37x23", "--check", "--dump"});
    ASSERT_EQ(records.size(), 2 * kAll.size());
    Names expected;
    for (size_t i = 0; i < records.size(); ++i) {
        const Json& record = records[i];
        const std::string light = i < kAll.size() ? "0" : "1", name = kAll[i % kAll.size()] + ".certified", stem = "scene-l" + light + "-f000";
        expectContract(record, true);
        EXPECT_EQ(record["technique"], kAll[i % kAll.size()]);
        EXPECT_EQ(record["precision"], "certified");
        EXPECT_EQ(record["light"], std::stoi(light));
        EXPECT_EQ(record["frame"], 0);
        EXPECT_EQ(record["size"], (Json{37, 23}));
        EXPECT_EQ(record["triangles"], 14);
        EXPECT_EQ(record["scene"], scene);
        EXPECT_EQ(record["effects"][0], light == "0" ? "point_light" : "directional_light");
        EXPECT_GT(record["in_shadow"].get<uint64_t>(), 0u);
        EXPECT_EQ(record["in_shadow"], records[i < kAll.size() ? 0 : kAll.size()]["in_shadow"]);

        // The picture holds what the record counts.
        const std::vector<float> mask = maskOf(stage.out() / (stem + ".exr"), name + ".visibility");
        EXPECT_EQ(mask.size(), 37u * 23u);
        EXPECT_EQ(uint64_t(std::count(mask.begin(), mask.end(), float(GNO_VISIBILITY_SHADOW))), record["in_shadow"].get<uint64_t>());

        const bool top = isTop(kAll[i % kAll.size()]), flat = kAll[i % kAll.size()] == "ptsv-2011", forest = kAll[i % kAll.size()] == "forest";
        const bool lists = kAll[i % kAll.size()] == "light-grid", boxes = kAll[i % kAll.size()] == "light-bvh";
        for (const char* picture : visitsNodes(kAll[i % kAll.size()]) ? std::vector{"shaded", "mask", "visited_nodes", "stack", "difference"}
                                                                      : std::vector{"shaded", "mask", "sample_tests", "difference"})
            expected.insert(stem + "-" + name + "-" + picture + ".png");
        expected.insert(stem + ".exr");
        std::vector<const char*> dumps{"casters.bin",       "states.bin",        "samples.bin", "visibility.bin",
                                       "oracle_shadow.bin", "oracle_caster.bin", "dump.json"};
        for (const char* more :
             top      ? std::vector{"header.bin", "planes.bin", "links.bin", "visits.bin", "visited_nodes.bin", "deepest_stack.bin"}
             : forest ? std::vector{"forest_header.bin", "grid.bin", "cells.bin", "pairs.bin", "planes.bin", "links.bin", "visited_nodes.bin",
                                    "deepest_stack.bin"}
             : boxes  ? std::vector{"grid.bin", "light_bvh_header.bin", "levels.bin", "nodes.bin", "parents.bin", "visited_nodes.bin",
                                   "deepest_stack.bin"}
             : lists  ? std::vector{"grid.bin", "lists.bin", "items.bin", "light_grid_header.bin", "visited_nodes.bin", "deepest_stack.bin"}
                      : std::vector{"header.bin", "frame.bin", "slices.bin", "masks.bin", "masks_built.bin", "volumes.bin", "low.bin", "high.bin",
                                   "sample_tests.bin"})
            dumps.push_back(more);
        if (!top && !flat && !forest && !lists && !boxes) dumps.push_back("pointers.bin");
        for (const char* dumped : dumps) expected.insert(stem + "-" + name + "-" + dumped);

        const Json index = Json::parse(readFile(stage.out() / (stem + "-" + name + "-dump.json")));
        EXPECT_EQ(index["casters"], 14);
        std::map<std::string, uint64_t> bytes;
        for (const Json& buffer : index["buffers"]) {
            bytes[buffer["name"]] = buffer["bytes"];
            EXPECT_EQ(buffer["bytes"], 4 * buffer["words"].get<uint64_t>() * buffer["count"].get<uint64_t>()) << buffer["name"];
            EXPECT_EQ(fs::file_size(stage.out() / buffer["file"].get<std::string>()), buffer["bytes"].get<uint64_t>()) << buffer["name"];
        }
        EXPECT_EQ(bytes.at("casters"), 14u * 36);
        EXPECT_EQ(bytes.at("samples"), 37u * 23 * 16);
        if (top) {
            EXPECT_EQ(bytes.at("planes"), topPlaneBytes(14));
            EXPECT_EQ(bytes.at("links"), topLinkBytes(14));
            EXPECT_EQ(bytes.at("header"), sizeof(GnoTopHeader));
        } else if (forest) {
            const uint64_t pairs = record["counters"]["pairs"];
            EXPECT_GT(pairs, 0u);
            EXPECT_EQ(bytes.at("grid"), sizeof(GnoForestGrid));
            EXPECT_EQ(bytes.at("forest_header"), sizeof(GnoForestHeader));
            EXPECT_EQ(bytes.at("cells") % (gnoCellCount(1, light == "0" ? 6 : 1) * sizeof(GnoForestCell)), 0u);
            EXPECT_EQ(bytes.at("pairs"), pairs * sizeof(GnoForestPair));
            EXPECT_EQ(bytes.at("planes"), topPlaneBytes(pairs));
            EXPECT_EQ(bytes.at("links"), topLinkBytes(pairs));
        } else if (boxes) {
            EXPECT_EQ(bytes.at("grid"), sizeof(GnoForestGrid));
            EXPECT_EQ(bytes.at("light_bvh_header"), sizeof(GnoLightBvhHeader));
            EXPECT_GT(bytes.at("nodes"), 0u);
            EXPECT_EQ(bytes.at("nodes") % sizeof(GnoLightBvhNode), 0u);
        } else if (lists) {
            EXPECT_EQ(bytes.at("grid"), sizeof(GnoForestGrid));
            EXPECT_EQ(bytes.at("light_grid_header"), sizeof(GnoLightGridHeader));
            const uint64_t nests = record["counters"]["nested_cells"], items = record["counters"]["items"];
            EXPECT_GT(items, 0u);
            EXPECT_EQ(bytes.at("lists"), sizeof(GnoLightGridList) * gnoLightGridLists(gnoCellCount(64, light == "0" ? 6 : 1), uint(nests)));
            EXPECT_EQ(bytes.at("items"), sizeof(GnoLightGridItem) * items);
        } else {
            EXPECT_EQ(bytes.at("frame"), sizeof(GnoClusterFrame) + sizeof(GnoClusterLayout));
            EXPECT_EQ(bytes.at("header"), sizeof(GnoClusterHeader));
            EXPECT_EQ(bytes.at("volumes"), 14u * 112);
            if (!flat) {
                EXPECT_EQ(bytes.at("low"), 12 * record["counters"]["boxes"].get<uint64_t>());
            }
        }
    }
    EXPECT_EQ(stage.left(), expected);

    Names channels{"position.X", "position.Y", "position.Z", "normal.X", "normal.Y", "normal.Z", "primitive"};
    for (const std::string& technique : kAll)
        for (const char* channel :
             visitsNodes(technique) ? std::vector{".visibility", ".visited_nodes", ".stack"} : std::vector{".visibility", ".sample_tests"})
            channels.insert(technique + ".certified" + channel);
    const host::ExrFile exr = host::readExr(stage.out() / "scene-l0-f000.exr");
    Names found;
    for (const auto& [name, pixels] : exr.channels) found.insert(name);
    EXPECT_EQ(found, channels);
    EXPECT_EQ(exr.width, 37u);
    EXPECT_EQ(exr.height, 23u);
    for (const auto& entry : fs::directory_iterator(stage.out())) {
        const bool isPng = readFile(entry.path()).starts_with("\x89PNG\r\n");
        EXPECT_EQ(isPng, entry.path().extension() == ".png") << entry.path();
    }
}

std::vector<uint32_t> wordsOf(const std::string& path) {
    const std::string bytes = readFile(path);
    std::vector<uint32_t> words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), 4 * words.size());
    return words;
}

TEST(Shade, TraceIsWhatTheCountersCounted) {
    const Stage stage;
    const std::string scene = stage.write("scene.glb", smallScene().glb());
    constexpr uint32_t kWidth = 37;
    shade(stage, {scene, "--technique", "psv", "--size", "37x23", "--dump", "--no-pictures"});
    const auto counts = wordsOf((stage.out() / "scene-l0-f000-psv.certified-visited_nodes.bin").string());
    const auto busiest = uint32_t(std::max_element(counts.begin(), counts.end()) - counts.begin());
    const uint32_t x = busiest % kWidth, y = busiest / kWidth;
    for (const char* precision : {"published", "certified"}) {
        const auto records = shade(stage, {scene, "--technique", "all", "--size", "37x23", "--dump", "--no-pictures", "--precision", precision,
                                           "--set", "stack=1", "--trace", std::to_string(x) + "," + std::to_string(y)});
        for (const Json& record : records) {
            const std::string stem = (stage.out() / ("scene-l0-f000-" + record["technique"].get<std::string>() + "." + precision + "-")).string();
            const Json index = Json::parse(readFile(stem + "dump.json"));
            EXPECT_EQ(index["record"], record);
            EXPECT_EQ(index.contains("trace"), isTop(record["technique"]));
            if (!isTop(record["technique"])) continue;
            const auto visits = wordsOf(stem + "visits.bin"), visited = wordsOf(stem + "visited_nodes.bin"), trace = wordsOf(stem + "trace.bin");
            EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), uint64_t(0)), record["counters"]["visited_nodes"].get<uint64_t>());
            ASSERT_EQ(trace.size(), 2 * size_t(visited.at(busiest)));
            ASSERT_GT(trace.size(), 2u);
            const uint32_t root = wordsOf(stem + "header.bin")[0];
            EXPECT_EQ(trace[0], root);
            const auto links = wordsOf(stem + "links.bin");
            for (size_t i = 0; i < trace.size(); i += 2) {  // each step is a link of the tree
                const uint32_t node = trace[i], before = i > 0 ? trace[i - 2] : 0;
                switch (trace[i + 1]) {
                    case 0:
                        EXPECT_EQ(i, 0u);
                        break;
                    case 1:
                        EXPECT_EQ(node, before + 1);
                        break;
                    case 2:
                        EXPECT_EQ(node, links[4 * before]);
                        break;
                    case 3:
                        EXPECT_EQ(node, links[4 * before + 1]);
                        break;
                    case 4:
                        EXPECT_NE(record["technique"], "d-stackless");
                        break;
                    case 5:
                        EXPECT_EQ(node, links[4 * ((before & ~3u) + 1) + 2]);
                        break;
                    default:
                        EXPECT_EQ(trace[i + 1], 6u);
                        EXPECT_EQ(node, root);
                        break;
                }
            }
        }
    }
}

TEST(Shade, TraceOfAPixelWithoutSample) {
    const Stage stage;
    const std::string scene = stage.write("scene.glb", smallScene().glb());
    expectRefusal(stage, stage.shade({scene, "--technique", "psv", "--size", "37x23", "--dump", "--trace", "0,0"}), 2, "background");
    expectRefusal(stage, stage.shade({scene, "--technique", "ptsv", "--size", "37x23", "--dump", "--trace", "17,20"}), 2, "d-hybrid");
}

TEST(Shade, EveryRungAndNoPictures) {
    const Stage stage;
    const std::string scene = stage.write("scene.glb", smallScene().glb());
    for (const char* precision : {"published", "conservative"}) {
        const auto records =
            shade(stage, {scene, "--technique", "d-stackless,psv,d-stackless", "--precision", precision, "--size", "16x16", "--no-pictures"});
        ASSERT_EQ(records.size(), 2u);
        EXPECT_EQ(records[0]["technique"], "d-stackless");
        EXPECT_EQ(records[1]["technique"], "psv");
        for (const Json& record : records) {
            expectContract(record, false);
            EXPECT_EQ(record["precision"], precision);
        }
    }
    EXPECT_EQ(stage.left(), Names());
}

TEST(Shade, AutoTellsWhatItPicks) {
    const Stage stage;
    const std::string scene = stage.write("scene.glb", smallScene().glb());
    const Outcome outcome = stage.shade({scene, "--size", "16x16", "--json", (stage.path() / "r").string(), "--no-pictures"});
    expectDone(outcome);
    EXPECT_NE(outcome.out.find("auto: "), std::string::npos) << outcome.out;
    const auto records = recordsOf(stage.path() / "r");
    ASSERT_EQ(records.size(), 1u);
    EXPECT_NE(outcome.out.find("auto: " + records[0]["technique"].get<std::string>()), std::string::npos) << outcome.out;
}

TEST(Shade, FramesOfAnAnimation) {
    const Stage stage;
    Builder builder = smallScene();
    const int times = builder.floats({0, 2.0f / 30}, "SCALAR", 1), moves = builder.floats({0, 0, 0, 1.5f, 0, 0}, "VEC3", 3);
    builder.add("animations", {{"samplers", {{{"input", times}, {"output", moves}, {"interpolation", "LINEAR"}}}},
                               {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}}});
    const auto records = shade(stage, {stage.write("moving.glb", builder.glb()), "--technique", "psv", "--frame", "0..2", "--size", "48x48"});
    ASSERT_EQ(records.size(), 3u);
    std::set<std::vector<float>> masks;
    for (int frame = 0; frame < 3; ++frame) {
        EXPECT_EQ(records[frame]["frame"], frame);
        EXPECT_EQ(records[frame]["animation"], 0);
        masks.insert(maskOf(stage.out() / ("moving-l0-f00" + std::to_string(frame) + ".exr"), "psv.certified.visibility"));
    }
    EXPECT_EQ(masks.size(), 3u);  // the cube moves, and with it its shadow
    EXPECT_EQ(stage.left().size(), 3u * 5u);
}

/// smallScene, whose cube two animations move, and a veil above it.
Builder oddScene() {
    Builder builder = smallScene();
    const int times = builder.floats({0, 1}, "SCALAR", 1), up = builder.positions({0, 1, 0, 0, 1, 0}), aside = builder.positions({1, 0, 0, 1, 0, 0});
    for (const auto& [name, moves] : {std::pair{"Up", up}, {"Aside", aside}})
        builder.add("animations", {{"name", name},
                                   {"samplers", {{{"input", times}, {"output", moves}}}},
                                   {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}}});
    builder.json["materials"] = {{{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.5}}}}}};
    builder.meshNode({-2, 3, -2, 3, 3, -2, 3, 3, 3});
    builder.json["meshes"][2]["primitives"][0]["material"] = 0;
    builder.json["extensionsUsed"] = {"VENDOR_unheard_of"};
    return builder;
}

TEST(Shade, TellsWhatItDoesNotUse) {
    const Stage stage;
    const std::string scene = stage.write("odd.glb", oddScene().glb());
    const std::vector<std::string> words{scene,           "--technique", "psv,ptsv", "--size", "24x24",
                                         "--no-pictures", "--frame",     "0..1",     "--json", stage.path() / "r"};
    const Outcome told = stage.shade(words);
    expectDone(told);
    const std::vector<std::string> notes{
        "extension VENDOR_unheard_of: not read, gnomon does not know it",
        "lights: the scene has none; made two: light 0, a point light above on the right, and light 1, directional from the upper left",
        "camera: the scene has none; made one that sees all of it",
        "animation: number 0 (Up) of 2 is taken; --animation N|NAME|all takes another, gnomon effects lists them",
        "alpha-tested and coloured casters: 1 of 15 triangles taken for opaque by psv (marked in the table)"};
    for (const std::string& note : notes) {
        const size_t at = told.out.find("note: " + note + "\n");
        EXPECT_NE(at, std::string::npos) << note << "\n" << told.out;
        EXPECT_EQ(told.out.find("note: " + note, at + 1), std::string::npos) << "once, not for every frame";
    }
    EXPECT_NE(told.out.find("taken as opaque"), std::string::npos) << told.out;
    const auto records = recordsOf(stage.path() / "r");
    ASSERT_EQ(records.size(), 4u);
    for (const Json& record : records) EXPECT_EQ(record["taken_for_opaque"], record["technique"] == "psv" ? 1 : 0);

    std::vector<std::string> quietly = words;
    quietly.insert(quietly.end(), {"--quiet", "--animation", "Aside"});
    const Outcome quiet = stage.shade(quietly);
    expectDone(quiet);
    EXPECT_EQ(quiet.out.find("note: "), std::string::npos) << quiet.out;
    const auto others = recordsOf(stage.path() / "r");
    ASSERT_EQ(others.size(), 4u);
    EXPECT_EQ(others[0]["animation"], 1);
    EXPECT_NE(others[0]["in_shadow"], records[0]["in_shadow"]);

    const Outcome effects = stage.run({"effects", scene, "--animation", "all"});
    expectDone(effects);
    for (const char* part : {"note: extension VENDOR_unheard_of: ", "animation 0 (Up) ends at 1.00 s, applied\n",
                             "animation 1 (Aside) ends at 1.00 s, applied\n", "1 triangle with a blended or transmitting material", "1 camera\n"})
        EXPECT_NE(effects.out.find(part), std::string::npos) << part << "\n" << effects.out;
    const Outcome quietEffects = stage.run({"effects", scene, "--quiet"});
    expectDone(quietEffects);
    EXPECT_EQ(quietEffects.out.find("note: "), std::string::npos) << quietEffects.out;
}

TEST(Shade, OneTriangleAndOnePixel) {
    const Stage stage;
    Builder builder;
    builder.meshNode(host::test::kTriangle);
    const auto records = shade(stage, {stage.write("one.glb", builder.glb()), "--technique", "all", "--light", "all", "--size", "1x1", "--check"});
    ASSERT_EQ(records.size(), 2 * kAll.size());
    for (const Json& record : records) {
        expectContract(record, true);
        EXPECT_EQ(record["triangles"], 1);
        EXPECT_LE(record["samples"].get<int>(), 1);
        EXPECT_EQ(record["in_shadow"], 0);
    }
}

TEST(Shade, DuplicatesAndTrianglesWithoutArea) {
    const Stage stage;
    Builder once = smallScene(), often = smallScene();
    for (int i = 0; i < 3; ++i) often.meshNode(host::test::kCube, host::test::kCubeIndices);
    often.meshNode({0, 0, 0, 0.5f, 0.5f, 0.5f, 1, 1, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0});
    const auto few = shade(stage, {stage.write("once.glb", once.glb()), "--technique", "d-hybrid", "--size", "40x40", "--check"});
    const auto many = shade(stage, {stage.write("often.glb", often.glb()), "--technique", "d-hybrid", "--size", "40x40", "--check"});
    ASSERT_EQ(few.size(), 1u);
    ASSERT_EQ(many.size(), 1u);
    expectContract(many[0], true);
    EXPECT_EQ(few[0]["triangles"], 14);
    EXPECT_EQ(many[0]["triangles"], 14 + 3 * 12);
    EXPECT_EQ(few[0]["samples"], many[0]["samples"]);
    EXPECT_EQ(maskOf(stage.out() / "once-l0-f000.exr", "d-hybrid.certified.visibility"),
              maskOf(stage.out() / "often-l0-f000.exr", "d-hybrid.certified.visibility"));

    const Outcome effects = stage.run({"effects", (stage.path() / "often.glb").string()});
    expectDone(effects);
    EXPECT_NE(effects.out.find("note: triangles without area on the grid: 2 of 52, neither seen nor casting\n"), std::string::npos) << effects.out;
    EXPECT_NE(effects.out.find("36 triangles there twice"), std::string::npos) << effects.out;
}

/// The mask of table_fan with these settings, and its record.
std::pair<std::vector<float>, Json> fan(const std::vector<std::string>& settings) {
    const Stage stage;
    std::vector<std::string> arguments{sceneFile("table_fan"), "--technique", "d-hybrid", "--size", "333x217", "--check"};
    for (const std::string& setting : settings) arguments.insert(arguments.end(), {"--set", setting});
    const auto records = shade(stage, arguments);
    if (records.size() != 1) throw std::runtime_error("no record");
    expectContract(records[0], true);
    return {maskOf(stage.out() / "table_fan-l0-f000.exr", "d-hybrid.certified.visibility"), records[0]};
}

TEST(Shade, FragmentStageGivesTheSameMask) {
    const auto [compute, computeRecord] = fan({"stage=compute"});
    const auto [fragment, fragmentRecord] = fan({"stage=fragment", "group=32", "stack=3"});
    EXPECT_EQ(compute.size(), 333u * 217u);
    EXPECT_EQ(compute, fragment);
    EXPECT_GT(computeRecord["in_shadow"].get<uint64_t>(), 100u);
    EXPECT_EQ(fragmentRecord["settings"]["stage"], "fragment");
    EXPECT_EQ(fragmentRecord["settings"]["group"], 32);
    EXPECT_EQ(fragmentRecord["settings"]["stack"], 3);
    EXPECT_EQ(fragmentRecord["settings"]["cull"], "none");
}

TEST(Shade, Culling) {
    const auto [none, noneRecord] = fan({});
    const auto [hull, hullRecord] = fan({"cull=hull"});
    const auto [front, frontRecord] = fan({"cull=front"});
    const auto [all, allRecord] = fan({"cull=all"});
    EXPECT_EQ(none, hull);  // drops nothing that matters
    EXPECT_EQ(none, front);
    EXPECT_EQ(front, all);
    const auto casters = [](const Json& record) { return record["casters"].get<uint64_t>(); };
    EXPECT_LE(casters(hullRecord), casters(noneRecord));
    EXPECT_LT(casters(frontRecord), casters(noneRecord));
    EXPECT_LE(casters(allRecord), casters(frontRecord));
    EXPECT_EQ(allRecord["settings"]["cull"], "all");
}

TEST(Tell, HelpAndVersion) {
    const Stage stage;
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"--help"}, {"-h"}, {"shade", "--help"}, {"effects", "--help"}, {"techniques", "--help"}, {"device", "--help"}}) {
        const Outcome outcome = stage.run(words);
        expectDone(outcome);
        EXPECT_NE(outcome.out.find("Usage"), std::string::npos) << outcome.out;
        if (words[0] != "shade") continue;
        for (const char* option : {"--technique", "--precision", "--size", "--camera", "--light", "--frame", "--animation", "--set", "--check",
                                   "--repeat", "--dump", "--out", "--json", "--quiet", "is replaced"})
            EXPECT_NE(outcome.out.find(option), std::string::npos) << option;
    }
    const Outcome version = stage.run({"--version"});
    expectDone(version);
    EXPECT_TRUE(version.out.starts_with("gnomon ")) << version.out;
    EXPECT_EQ(linesOf(version.out).size(), 1u);
}

TEST(Tell, Device) {
    const Outcome outcome = Stage().run({"device"});
    expectDone(outcome);
    for (const char* part : {"driver", "subgroup width", "maxStorageBufferRange", "in use: "})
        EXPECT_NE(outcome.out.find(part), std::string::npos) << part;
}

TEST(Tell, Techniques) {
    const Outcome outcome = Stage().run({"techniques"});
    expectDone(outcome);
    for (const std::string& technique : kAll) EXPECT_NE(outcome.out.find("\n" + technique + " "), std::string::npos) << technique;
    for (const char* part : {"not in this build yet", "\nshadow-map ", "--set stack=1..64", "--set bias=0.0..64.0", "--set map=512..8192",
                             "--set cull=none|front|hull|all", "default 12", "default 32"})
        EXPECT_NE(outcome.out.find(part), std::string::npos) << part;
}

TEST(Tell, Effects) {
    const Stage stage;
    const Outcome small = stage.run({"effects", stage.write("scene.glb", smallScene().glb())});
    expectDone(small);
    for (const char* part : {"14 triangles", "point_light", "directional_light", "closed_casters", "open_casters", "one-sided", "auto would run"})
        EXPECT_NE(small.out.find(part), std::string::npos) << part << "\n" << small.out;
    const Outcome shipped = stage.run({"effects", sceneFile("table_fan"), "--frame", "7"});
    expectDone(shipped);
    EXPECT_NE(shipped.out.find("triangles"), std::string::npos);
    EXPECT_EQ(stage.left(), Names());
}

}  // namespace
}  // namespace gno::test
