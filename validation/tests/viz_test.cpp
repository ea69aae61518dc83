// SPDX-License-Identifier: MIT
// gnomon-viz: the VTK files it writes hold what the device counted, its pictures show something, and bad input ends in one line.
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <optional>

#include "validation/tests/viz_look.hpp"
#include "viz/display.hpp"

namespace gno::test {
namespace {

const std::vector<std::string> kTop{"d-psv", "psv", "d-stackless", "d-hybrid"};

/// What differs between the tree that was written and the device's counters; empty: nothing.
std::string differences(vtkPolyData& nodes, const Json& record) {
    std::string text;
    if (uint64_t(nodes.GetNumberOfPoints()) != counter(record, "inserted")) text += "nodes ";
    if (sumOf(*nodes.GetPointData(), "visits", "visits") != double(counter(record, "visited_nodes"))) text += "visits ";
    return text;
}

/// The pixel whose query visits most nodes.
std::string busiestPixel(const Look& look, const std::string& technique) {
    const auto visited = wordsOf(look.file(technique, "visited_nodes.bin"));
    const auto at = uint32_t(std::max_element(visited.begin(), visited.end()) - visited.begin());
    return std::to_string(at % kWidth) + "," + std::to_string(at / kWidth);
}

/// One for all tests of the program, and for its children.
class DisplayOfAll : public testing::Environment {
    void SetUp() override { display_.emplace(); }
    void TearDown() override { display_.reset(); }
    std::optional<viz::Display> display_;
};
const auto* const kDisplay = testing::AddGlobalTestEnvironment(new DisplayOfAll);  // owned by gtest

class Viz : public testing::TestWithParam<const char*> {};

TEST_P(Viz, TreeHoldsWhatTheDeviceCounted) {
    const Look look(sceneFile(GetParam()));
    look.shade({"--technique", "d-psv"});
    look.shade({"--technique", "psv,d-psv,d-stackless,d-hybrid", "--trace", busiestPixel(look, "d-psv")});
    std::vector<std::string> arguments{"tree", "--limit", "50", "--color", "kind", "--size", "640x480"};
    for (const std::string& technique : kTop) arguments.push_back(look.dump(technique));
    const Outcome outcome = look.viz(arguments);
    expectDone(outcome);
    const Json record = look.record("d-psv");
    EXPECT_NE(outcome.out.find("drawing 50 of "), std::string::npos) << outcome.out;

    const auto nodes = meshIn(look.file("d-psv", "tree-nodes.vtp"));
    EXPECT_EQ(differences(*nodes, record), "");
    Json more = record;
    more["counters"]["inserted"] = counter(record, "inserted") + 1;
    EXPECT_EQ(differences(*nodes, more), "nodes ");
    EXPECT_EQ(nodes->GetNumberOfLines(), nodes->GetNumberOfPoints() - 1);
    const Json statistics = Json::parse(readFile(look.file("d-psv", "tree-statistics.json")));
    EXPECT_EQ(statistics["visits"], record["counters"]["visited_nodes"]);
    EXPECT_EQ(statistics["volumes"], record["counters"]["inserted"]);

    const auto volumes = meshIn(look.file("d-psv", "tree-volumes.vtp"));
    EXPECT_EQ(factIn(*volumes, "volumes_drawn"), 50);
    EXPECT_EQ(factIn(*volumes, "volumes_in_tree"), double(counter(record, "inserted")));
    EXPECT_GE(sumOf(*volumes->GetCellData(), "least_distance", "m"), 0);
    for (const std::string& technique : kTop) {
        const Json index = Json::parse(readFile(look.dump(technique)));
        const size_t pixel = index["trace"][1].get<size_t>() * kWidth + index["trace"][0].get<size_t>();
        const auto path = meshIn(look.file(technique, "tree-path.vtp"));
        EXPECT_EQ(uint32_t(path->GetNumberOfPoints()), wordsOf(look.file(technique, "visited_nodes.bin")).at(pixel)) << technique;
        EXPECT_EQ(factIn(*path, "ancestor_jumps") > 0, technique == "d-stackless") << technique;
    }
    expectDone(look.viz({"tree", look.dump("d-hybrid"), "--interactive", "--close-after", "1", "--size", "640x480"}));
    for (const char* picture : {"tree-kind.png", "tree-statistics.png", "tree-path.png", "tree-steps.png"})
        expectPicture(look.file("d-psv", picture));
}

TEST_P(Viz, ClustersHoldWhatTheDeviceCounted) {
    const Look look(sceneFile(GetParam()));
    look.shade({"--technique", "ptsv,ptsv-2011", "--set", "materials=off"});
    for (const char* technique : {"ptsv", "ptsv-2011"}) {
        expectDone(look.viz({"clusters", look.dump(technique), "--size", "640x480"}));
        const Json record = look.record(technique);
        const auto cells = meshIn(look.file(technique, "clusters-implicit.vtp"));
        EXPECT_EQ(uint64_t(cells->GetNumberOfCells()), 6 * counter(record, "occupied_nodes"));
        EXPECT_EQ(sumOf(*cells->GetCellData(), "accepted"), 6.0 * double(counter(record, "accepted_nodes")));
        EXPECT_GT(sumOf(*cells->GetCellData(), "distance", "m"), 0);
        const bool flat = std::string(technique) == "ptsv-2011";
        EXPECT_EQ(fs::exists(look.file(technique, "clusters-explicit.vtp")), !flat);
        if (!flat) {
            EXPECT_EQ(uint64_t(meshIn(look.file(technique, "clusters-explicit.vtp"))->GetNumberOfCells()), 6 * counter(record, "boxes"));
        }
        const int levels = int(factIn(*cells, "levels"));
        EXPECT_GE(levels, 2);
        for (int level = 1; level <= levels; ++level) expectPicture(look.file(technique, "clusters-level-" + std::to_string(level) + ".png"));
        EXPECT_FALSE(fs::exists(look.file(technique, "clusters-level-" + std::to_string(levels + 1) + ".png")));
        expectPicture(look.file(technique, "clusters-tests.png"));
        vtkNew<vtkXMLImageDataReader> pixels;
        pixels->SetFileName(look.file(technique, "clusters-pixels.vti").c_str());
        pixels->Update();
        EXPECT_EQ(sumOf(*pixels->GetOutput()->GetPointData(), "sample_tests", "tests"), double(counter(record, "leaf_tests")));
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Viz, testing::Values("table_fan", "fence", "spiral_staircase"));

TEST(VizStairs, SamplesAreThoseTheOracleCounted) {
    const Look look(std::string(GNOMON_SCENES_DIR) + "/show_stairs.glb");
    look.shade({"--technique", "d-hybrid", "--precision", "published", "--check"}, "480x300");
    const Json check = look.record("d-hybrid", "published")["check"];
    ASSERT_GT(check["wrong"].get<uint64_t>(), 0u);
    expectDone(look.viz({"samples", look.dump("d-hybrid", "published"), "--size", "640x480"}));
    const auto points = meshIn(look.file("d-hybrid", "samples.vtp", "published"));
    EXPECT_EQ(uint64_t(points->GetNumberOfPoints()), check["wrong"].get<uint64_t>());
    EXPECT_EQ(sumOf(*points->GetPointData(), "error"), check["false_dark"].get<double>());
    EXPECT_NE(points->GetPointData()->GetArray("distance"), nullptr);
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)  // a leak lies inside the volume that it leaked through
        if (points->GetPointData()->GetArray("error")->GetComponent(i, 0) == 0) {
            EXPECT_LE(points->GetPointData()->GetArray("distance")->GetComponent(i, 0), 1e-9);
        }
    EXPECT_EQ(sumOf(*meshIn(look.file("d-hybrid", "samples-planes.vtp", "published"))->GetCellData(), "samples"), check["wrong"].get<double>());
    expectPicture(look.file("d-hybrid", "samples.png", "published"));
}

class VizSmall : public testing::Test {
protected:
    static const Look& look() {
        static const Stage stage;
        static const Look look(stage.write("small.glb", smallScene().glb()));
        return look;
    }
    static void SetUpTestSuite() { look().shade({"--technique", "psv,ptsv", "--check"}); }
};

TEST_F(VizSmall, NothingIsWrongOnTheCertifiedRung) {
    const Outcome outcome = look().viz({"samples", look().dump("psv")});
    expectDone(outcome);
    EXPECT_NE(outcome.out.find(": 0 of "), std::string::npos) << outcome.out;
    EXPECT_EQ(meshIn(look().file("psv", "samples.vtp"))->GetNumberOfPoints(), 0);
    expectPicture(look().file("psv", "samples.png"));
}

TEST_F(VizSmall, InteractiveOpensAndCloses) {
    for (const std::string command : {"tree", "clusters", "samples"})
        expectDone(
            look().viz({command, look().dump(command == "tree" ? "psv" : "ptsv"), "--interactive", "--close-after", "1", "--size", "640x480"}));
}

TEST_F(VizSmall, BadInput) {
    const std::string tree = look().dump("psv"), clusters = look().dump("ptsv");
    look().refuses({"tree", clusters}, "no TOP tree");
    look().refuses({"clusters", tree}, "no cluster hierarchy");
    look().refuses({"tree", "none-dump.json"}, "cannot be opened");
    look().refuses({"tree", look().file("psv", "links.bin").string()}, "not the index of a dump");
    look().refuses({"tree", tree, "--color", "rainbow"}, "depth, kind, distance, visits");
    look().refuses({"tree", tree, "--view", "below"}, "overview");
    look().refuses({"tree", tree, "--limit", "0"}, "--limit");
    look().refuses({"tree", tree, "--size", "10x10"}, "--size");
    look().refuses({"tree", tree, "--close-after", "3"}, "--interactive");
    look().refuses({"tree", tree, tree, "--limit", "9"}, "trace");
    look().refuses({"clusters", clusters, clusters}, "one dump");
    look().refuses({"stars", tree}, "gnomon-viz --help");
    look().refuses({"tree"}, "DUMP");
    look().refuses({"tree", tree}, "no display", {{"DISPLAY", ":987"}, {"PATH", "/nowhere"}});
    look().refuses({"tree", tree, "--interactive"}, "no display", {{"DISPLAY", ":987"}});
}

TEST_F(VizSmall, DamagedDumps) {
    const std::vector<std::string> tree{"tree", look().dump("psv")}, clusters{"clusters", look().dump("ptsv")},
        samples{"samples", look().dump("psv")};
    look().refusesDamaged(look().file("psv", "links.bin"), withoutLastWord, tree, "links");
    look().refusesDamaged(look().dump("psv"), firstHalf, tree, "not the index");

    // A subtree taken out, a link that leads back to the root, a link that leads nowhere.
    const auto links = wordsOf(look().file("psv", "links.bin"));
    const uint32_t root = wordsOf(look().file("psv", "header.bin"))[0];
    size_t link = 0;
    for (uint32_t place = 0; place < 4 && link == 0; ++place)
        for (uint32_t which = 0; which < 2 && link == 0; ++which)
            if (links[4 * (root + place) + which] != 0xFFFFFFFFu) link = 4 * (root + place) + which;
    ASSERT_GT(link, 0u);
    look().refusesDamaged(look().file("psv", "links.bin"), setWord(link, 0xFFFFFFFFu), tree, "the record counted");
    look().refusesDamaged(look().file("psv", "links.bin"), setWord(link, root), tree, "twice");
    look().refusesDamaged(look().file("psv", "links.bin"), setWord(link, 4 * 1000000), tree, "broken");

    // A node taken out, a count changed.
    const auto masks = wordsOf(look().file("ptsv", "masks_built.bin"));
    look().refusesDamaged(look().file("ptsv", "masks_built.bin"), setWord(0, masks[0] & (masks[0] - 1)), clusters, "");
    look().refusesDamaged(look().dump("ptsv"), raise("counters", "occupied_nodes"), clusters, "the record counted");
    look().refusesDamaged(look().dump("psv"), raise("counters", "visited_nodes"), tree, "the record counted");
    look().refusesDamaged(look().dump("psv"), raise("check", "wrong"), samples, "its record says");
    expectDone(look().viz({"clusters", look().dump("ptsv")}));
}

}  // namespace
}  // namespace gno::test
