// SPDX-License-Identifier: MIT
// gnomon-viz forest: its files hold what the device counted, cell by cell; other views and damaged dumps are refused in one line.
#include <vtkCellData.h>

#include <algorithm>
#include <cmath>

#include "validation/tests/viz_look.hpp"

namespace gno::test {
namespace {

constexpr uint32_t kNone = 0xFFFFFFFFu;

std::string grouped(uint64_t number) {
    std::string digits = std::to_string(number);
    for (size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, 1, ',');
    return digits;
}

/// What differs between the cells that were written and the device's counters; empty: nothing.
std::string differences(vtkPolyData& cells, const Json& record) {
    std::string text;
    vtkDataSetAttributes& data = *cells.GetCellData();
    uint64_t used = 0;
    double visits = 0;
    for (vtkIdType i = 0; i < cells.GetNumberOfCells(); ++i) {
        used += data.GetArray("casters")->GetComponent(i, 0) > 0;
        visits += data.GetArray("visits_per_sample")->GetComponent(i, 0) * data.GetArray("samples")->GetComponent(i, 0);
    }
    if (sumOf(data, "casters", "casters") != double(counter(record, "pairs")) || factIn(cells, "pairs") != double(counter(record, "pairs")))
        text += "pairs ";
    if (used != counter(record, "used_cells") || factIn(cells, "used_cells") != double(used)) text += "used ";
    if (sumOf(data, "volumes", "volumes") != double(counter(record, "inserted")) || factIn(cells, "volumes") != double(counter(record, "inserted")))
        text += "inserted ";
    if (factIn(cells, "visits") != double(counter(record, "visited_nodes")) || std::abs(visits / factIn(cells, "visits") - 1) > 1e-5)
        text += "visits ";
    if (factIn(cells, "resolution") != double(counter(record, "cells"))) text += "resolution ";
    return text;
}

struct Case {
    std::string scene;
    uint32_t light, faces;
    std::string nodes, slab;
};

void PrintTo(const Case& one, std::ostream* out) { *out << fs::path(one.scene).stem().string() << ", light " << one.light; }

class VizForest : public testing::TestWithParam<Case> {};

TEST_P(VizForest, CellsHoldWhatTheDeviceCounted) {
    const Look look(GetParam().scene, GetParam().light);
    look.shade({"--technique", "forest", "--set", "cells=16", "--set", "nodes=" + GetParam().nodes, "--set", "slab=" + GetParam().slab});
    const Outcome outcome = look.viz({"forest", look.dump("forest"), "--limit", "50", "--size", "640x480"});
    expectDone(outcome);
    const Json record = look.record("forest");
    EXPECT_NE(
        outcome.out.find(grouped(counter(record, "pairs")) + " pairs of cell and caster in " + grouped(counter(record, "used_cells")) + " of "),
        std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find(grouped(counter(record, "inserted")) + " of them in the cells' trees"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("drawing 50 of "), std::string::npos) << outcome.out;

    const auto cells = meshIn(look.file("forest", "forest-cells.vtp"));
    EXPECT_EQ(uint64_t(cells->GetNumberOfCells()), GetParam().faces * counter(record, "cells") * counter(record, "cells"));
    EXPECT_EQ(differences(*cells, record), "");
    for (const auto& [name, what] : {std::pair("pairs", "pairs "), std::pair("inserted", "inserted "), std::pair("visited_nodes", "visits ")}) {
        Json more = record;
        more["counters"][name] = counter(record, name) + 1;
        EXPECT_EQ(differences(*cells, more), what);
    }

    // The device saw samples in the same cells, and most casters are really in the fullest one: its borders are where the device has them.
    const auto stored = wordsOf(look.file("forest", "cells.bin"));
    vtkDataSetAttributes& data = *cells->GetCellData();
    vtkIdType fullest = 0;
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i) {
        EXPECT_EQ(stored[4 * size_t(i)] != 0, data.GetArray("samples")->GetComponent(i, 0) > 0) << "cell " << i;
        if (data.GetArray("casters")->GetComponent(i, 0) > data.GetArray("casters")->GetComponent(fullest, 0)) fullest = i;
    }
    const std::string stem = "forest-cell-" + std::to_string(fullest);
    const auto tree = meshIn(look.file("forest", stem + ".vtp"));
    EXPECT_EQ(tree->GetNumberOfCells(), 50);
    EXPECT_EQ(factIn(*tree, "volumes_in_tree"), data.GetArray("volumes")->GetComponent(fullest, 0));
    EXPECT_LE(factIn(*tree, "kept_by_margins"), 0.02 * factIn(*tree, "volumes_in_tree"));
    EXPECT_TRUE(std::isfinite(sumOf(*tree->GetCellData(), "least_distance", "m")));  // of a directional light they may be negative
    EXPECT_EQ(tree->GetCellData()->GetArray("parent")->GetComponent(0, 0), double(kNone));
    EXPECT_GT(meshIn(look.file("forest", stem + "-parts.vtp"))->GetNumberOfCells(), 0);
    EXPECT_EQ(meshIn(look.file("forest", stem + "-pyramid.vtp"))->GetNumberOfLines(), 12);
    for (const std::string& picture : {std::string("forest-casters.png"), std::string("forest-visits.png"), stem + "-depth.png"})
        expectPicture(look.file("forest", picture));
}

INSTANTIATE_TEST_SUITE_P(Scenes, VizForest,
                         testing::Values(Case{sceneFile("fence"), 0, 6, "128", "off"},
                                         Case{std::string(GNOMON_SCENES_DIR) + "/show_stairs.glb", 1, 1, "64", "on"}));

class VizForestSmall : public testing::Test {
protected:
    static const Look& look() {
        static const Stage stage;
        static const Look look(stage.write("small.glb", smallScene().glb()));
        return look;
    }
    static void SetUpTestSuite() { look().shade({"--technique", "forest,psv", "--set", "cells=4", "--check"}); }
    static std::string dump() { return look().dump("forest"); }
    static fs::path file(const std::string& buffer) { return look().file("forest", buffer + ".bin"); }
};

TEST_F(VizForestSmall, OtherViews) {
    look().refuses({"tree", dump()}, "use `gnomon-viz forest`");
    look().refuses({"clusters", dump()}, "no cluster hierarchy");
    look().refuses({"forest", look().dump("psv")}, "no forest");
    const Outcome samples = look().viz({"samples", dump()});
    expectDone(samples);
    EXPECT_NE(samples.out.find(": 0 of "), std::string::npos) << samples.out;
    expectDone(look().viz({"forest", dump(), "--interactive", "--close-after", "1", "--size", "640x480"}));
}

TEST_F(VizForestSmall, BadInput) {
    look().refuses({"forest", dump(), dump()}, "one dump");
    look().refuses({"forest", dump(), "--cell", "96"}, "0..95");
    look().refuses({"forest", dump(), "--cell", "first"}, "--cell");
    look().refuses({"forest", dump(), "--color", "visits"}, "depth, kind, distance");
    look().refuses({"tree", look().dump("psv"), "--cell", "1"}, "--cell");
    const auto cells = wordsOf(file("cells"));
    size_t empty = 0;
    while (cells[4 * empty + 3] != kNone) ++empty;
    look().refuses({"forest", dump(), "--cell", std::to_string(empty)}, "keeps no casters");
}

TEST_F(VizForestSmall, EachUsedCellIsDrawn) {
    const auto cells = wordsOf(file("cells"));
    for (size_t cell = 0; cell < cells.size() / 4; ++cell) {
        if (cells[4 * cell + 3] == kNone) continue;
        expectDone(look().viz({"forest", dump(), "--cell", std::to_string(cell), "--color", "kind", "--size", "400x300"}));
        EXPECT_TRUE(fs::exists(look().file("forest", "forest-cell-" + std::to_string(cell) + "-kind.png")));
    }
}

/// As where no caster lies before any view sample: two maps, and no tree.
TEST_F(VizForestSmall, EmptyForest) {
    const fs::path folder = file("cells").parent_path() / "empty";
    fs::create_directory(folder);
    for (const auto& entry : fs::directory_iterator(folder.parent_path()))
        if (entry.is_regular_file()) fs::copy(entry.path(), folder / entry.path().filename());
    const auto change = [&](const std::string& buffer, auto changed) {
        auto words = wordsOf(file(buffer));
        changed(words);
        replaceFile(folder / file(buffer).filename(), std::string(reinterpret_cast<const char*>(words.data()), 4 * words.size()));
    };
    change("cells", [](std::vector<uint32_t>& words) {
        for (size_t i = 0; i < words.size(); i += 4) words[i + 2] = 0, words[i + 3] = kNone;
    });
    change("forest_header", [](std::vector<uint32_t>& words) { words[3] = words[12] = 0; });
    change("visited_nodes", [](std::vector<uint32_t>& words) { std::fill(words.begin(), words.end(), 0u); });
    Json index = Json::parse(readFile(dump()));
    for (const char* name : {"pairs", "used_cells", "visited_nodes"}) index["record"]["counters"][name] = 0;
    const fs::path empty = folder / fs::path(dump()).filename();
    replaceFile(empty, index.dump());
    const Outcome outcome = look().viz({"forest", empty.string(), "--size", "640x480"});
    expectDone(outcome);
    EXPECT_NE(outcome.out.find("0 pairs of cell and caster in 0 of 96 cells"), std::string::npos) << outcome.out;
    for (const char* picture : {"forest-casters.png", "forest-visits.png"}) EXPECT_TRUE(fs::exists(look().file("forest", picture)));
    look().refuses({"forest", empty.string(), "--cell", "0"}, "no cell of the forest keeps a caster");
    fs::remove_all(folder);
}

TEST_F(VizForestSmall, DamagedDumps) {
    const std::vector<std::string> forest{"forest", dump()};
    const auto damaged = [&](const std::string& buffer, auto change, const std::string& part) {
        look().refusesDamaged(file(buffer), change, forest, part);
    };
    for (const std::string buffer : {"grid", "cells", "pairs", "forest_header", "links", "samples", "visited_nodes"})
        damaged(buffer, withoutLastWord, buffer);
    look().refusesDamaged(dump(), firstHalf, forest, "not the index");

    const auto cells = wordsOf(file("cells")), pairs = wordsOf(file("pairs")), links = wordsOf(file("links")),
               visited = wordsOf(file("visited_nodes"));
    damaged("grid", setWord(10, 5), "none of a forest");
    damaged("grid", setWord(11, 1), "none of a forest");
    damaged("forest_header", setWord(3, 1u << 20), "not complete");
    damaged("forest_header", setWord(12, 1), "the header says");
    damaged("pairs", setWord(0, 1u << 20), "pool is broken");
    damaged("pairs", setWord(1, 1u << 20), "pool is broken");
    damaged("pairs", setWord(1, (pairs[1] + 1) % 96), "pool is broken");
    size_t used = 0;  // a cell whose root has a child
    size_t link = 0;
    for (; link == 0; ++used) {
        ASSERT_LT(4 * used, cells.size());
        for (size_t node = 0; node < 4 && link == 0 && cells[4 * used + 3] != kNone; ++node)
            for (size_t which = 0; which < 2 && link == 0; ++which)
                if (links[4 * (cells[4 * used + 3] + node) + which] != kNone) link = 4 * (cells[4 * used + 3] + node) + which;
    }
    const uint32_t root = cells[4 * --used + 3];
    damaged("cells", setWord(4 * used + 2, cells[4 * used + 2] + 1), "pool is broken");
    damaged("cells", setWord(4 * used + 3, kNone), "no link leads to it");
    damaged("cells", setWord(4 * used + 3, root + 1), "tree is broken");
    damaged("links", setWord(link, root), "twice");
    damaged("links", setWord(link, 4u << 20), "tree is broken");
    const size_t counted = size_t(std::max_element(visited.begin(), visited.end()) - visited.begin());
    damaged("visited_nodes", setWord(counted, visited[counted] + 1), "the record counted");
    for (const char* name : {"pairs", "used_cells", "visited_nodes"})
        look().refusesDamaged(dump(), raise("counters", name), forest, "the record counted");
    expectDone(look().viz(forest));
}

}  // namespace
}  // namespace gno::test
