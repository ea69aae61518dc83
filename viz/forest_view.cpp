// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "host_min/error.hpp"
#include "host_min/output/atomic_file.hpp"
#include "viz/files.hpp"
#include "viz/forest_map.hpp"
#include "viz/forest_tree.hpp"
#include "viz/views.hpp"

namespace gno::viz {
namespace {

std::string summary(const Forest& forest) {
    return fmt::format("{} pairs of cell and caster in {} of {} cells, {} of them in the cells' trees; {:.1f} visited nodes a sample",
                       grouped(forest.casterOfBlock.size()), grouped(forest.used), grouped(forest.cells.size()), grouped(forest.volumes),
                       double(forest.visits) / double(std::max<uint64_t>(1, forest.samples)));
}

/// "21,983 casters, cell 68 (face +x, column 4, row 4)"
std::string mostOf(const Forest& forest, const std::string& color) {
    const uint32_t cell = color == "casters" ? forest.fullestCell() : forest.dearestCell();
    const ForestCell& own = forest.cells[cell];
    if (color == "casters") return fmt::format("{} casters, {}", grouped(own.casters), cellName(forest, cell));
    return fmt::format("{:.1f} visited nodes a sample, {}", own.visitsPerSample(), cellName(forest, cell));
}

std::string leftOut(const CellTree& tree, size_t drawn) {
    if (drawn == tree.volumes.size()) return fmt::format("drawing all {} casters of the cell's tree", grouped(drawn));
    return fmt::format("drawing {} of {} casters of the cell's tree: those nearest to the root (--limit)", grouped(drawn),
                       grouped(tree.volumes.size()));
}

void writeCells(const Options& options, const Dump& dump, const Forest& forest) {
    writeFile(options.out / (dump.name() + "-forest-cells.vtp"), *cellMesh(dump, forest));
    for (const std::string color : {"casters", "visits"}) {
        Picture picture(options.size, fmt::format("forest, {} by cell: {}", color, dump.title()));
        drawCells(picture, dump, forest, color);
        picture.note(summary(forest));
        picture.note(fmt::format("the most: {}; ", mostOf(forest, color)) +
                     "grey: no caster can shadow a view sample in it, a query ends at once; nearly white: there is no view sample in it");
        picture.note("settings: " + dump.record().value("settings", nlohmann::json()).dump());
        picture.writePng(options.out / fmt::format("{}-forest-{}.png", dump.name(), color));
    }
}

/// Left panel: whole casters in the scene; right panel: what the cell sees of them.
class TreePicture {
public:
    TreePicture(const Options& options, const Dump& dump, const Forest& forest, const CellTree& tree, std::span<const Corners> corners)
        : dump_(dump),
          tree_(tree),
          corners_(corners),
          coloring_(coloringOf(options.color, tree.volumes)),
          picture_(sizeOf(options), fmt::format("forest, {}: {}", cellName(forest, tree.cell), dump.title()), options.interactive) {
        const auto pyramid = pyramidMesh(dump, forest, tree);
        for (const int panel : {0, 1}) {
            addMesh(picture_.panel(panel), *pyramid, {.colour = kVermilion, .lit = false, .lineWidth = 2});
            addBall(picture_.panel(panel), lightMarkOf(dump), 0.012 * glm::length(dump.high() - dump.low()) * dump.metres(), kYellow);
        }
        addMesh(picture_.panel(0), *meshOf(dump, corners, largestCasters(corners, 20000)),
                {.colour = kPale, .opacity = 0.25, .outlines = true, .lit = false, .lineWidth = 0.5});
        addLegend(picture_, options.color == "kind" ? 0 : 1, options.color, coloring_);  // kinds stand in a corner, and here is room for them
        picture_.panelTitle(0, "the cell's casters in the scene");
        picture_.panelTitle(1, "their parts inside the cell");
        picture_.lookAt(dump, options.view, boxOf(dump), {0});
        picture_.lookAt(dump, View::overview, tree.box, {1});
    }
    void draw(size_t count) {
        for (int panel = 0; panel < 2; ++panel)
            if (drawn_[size_t(panel)]) picture_.panel(panel).RemoveActor(drawn_[size_t(panel)]);
        drawn_ = {};
        if (count == 0) return;
        const auto whole = casterMesh(dump_, tree_, corners_, count);
        fade(*whole, dump_, corners_, coloring_);
        drawn_ = {addMesh(picture_.panel(0), *whole, {.lit = false}, "drawn"),
                  addMesh(picture_.panel(1), *partMesh(dump_, tree_, count), {.edges = count > 500 ? 0.0 : 0.6, .lit = false}, coloring_.array,
                          coloring_.table)};
    }
    Picture& picture() { return picture_; }

private:
    static PictureSize sizeOf(const Options& options) {
        PictureSize size = options.size;
        size.columns = 2;
        return size;
    }
    const Dump& dump_;
    const CellTree& tree_;
    std::span<const Corners> corners_;
    Coloring coloring_;
    Picture picture_;
    std::array<vtkSmartPointer<vtkActor>, 2> drawn_;
};

void show(const Options& options, const Dump& dump, const Forest& forest, const CellTree& tree, std::span<const Corners> corners, size_t drawn) {
    TreePicture view(options, dump, forest, tree, corners);
    const int deepest = drawn > 0 ? int(tree.volumes[drawn - 1].depth) : 0;
    const auto upTo = [&](int depth) {
        const auto end = std::partition_point(tree.volumes.begin(), tree.volumes.begin() + ptrdiff_t(drawn),
                                              [&](const Volume& v) { return int(v.depth) <= depth; });
        view.draw(size_t(end - tree.volumes.begin()));
    };
    upTo(deepest);
    view.picture().note(leftOut(tree, drawn));
    view.picture().show({"deepest level that is drawn", 0, std::max(1, deepest), deepest, upTo}, options.closeAfter);
}

void writeTree(const Options& options, const Dump& dump, const Forest& forest, const CellTree& tree, std::span<const Corners> corners,
               size_t drawn) {
    const std::string stem = fmt::format("{}-forest-cell-{}", dump.name(), tree.cell);
    writeFile(options.out / (stem + ".vtp"), *casterMesh(dump, tree, corners, drawn));
    writeFile(options.out / (stem + "-parts.vtp"), *partMesh(dump, tree, drawn));
    writeFile(options.out / (stem + "-pyramid.vtp"), *pyramidMesh(dump, forest, tree));
    TreePicture view(options, dump, forest, tree, corners);
    view.draw(drawn);
    view.picture().note(tree.numbers(forest));
    view.picture().note(leftOut(tree, drawn));
    view.picture().note("vermilion: the cell, as far as its farthest view sample (without one: to the end of the scene); yellow ball: the light");
    view.picture().writePng(options.out / fmt::format("{}-{}.png", stem, options.color));
}

}  // namespace

void viewForest(const Options& options) {
    if (options.dumps.size() > 1) throw host::InputError("forest: one dump at a time");
    const Dump dump = Dump::load(options.dumps.front());
    const Forest forest = Forest::read(dump);
    const std::vector<Corners> corners = cornersOf(dump);
    if (forest.used == 0 && (options.cell || options.interactive))
        throw host::InputError(fmt::format("{}: no cell of the forest keeps a caster", dump.name()));
    CellTree tree;
    if (forest.used > 0) tree = CellTree::read(dump, forest, corners, options.cell.value_or(forest.fullestCell()));
    const size_t drawn = std::min<size_t>(options.limit, tree.volumes.size());
    if (options.interactive) return show(options, dump, forest, tree, corners, drawn);

    host::makeFolder(options.out);
    writeCells(options, dump, forest);
    if (forest.used > 0) writeTree(options, dump, forest, tree, corners, drawn);
    fmt::print("{}: {}\n", dump.title(), summary(forest));
    if (forest.used > 0) fmt::print("{}: {}; {}\n", cellName(forest, tree.cell), tree.numbers(forest), leftOut(tree, drawn));
}

}  // namespace gno::viz
