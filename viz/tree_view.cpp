// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "host_min/error.hpp"
#include "host_min/output/atomic_file.hpp"
#include "viz/files.hpp"
#include "viz/query_path.hpp"
#include "viz/shadow_volume.hpp"
#include "viz/tree_charts.hpp"
#include "viz/tree_paths.hpp"
#include "viz/views.hpp"
#include "viz/volume_look.hpp"

namespace gno::viz {
namespace {

void addTreeFacts(vtkPolyData& mesh, const Dump& dump, const TopTree& tree) {
    addFact(mesh, "title", dump.title());
    addFact(mesh, "casters", double(tree.casters));
    addFact(mesh, "volumes_in_tree", double(tree.volumes.size()));
    addFact(mesh, "links", kLinksFact);
}

/// The first `count` volumes of the tree, clipped to the scene's box: one polygon per face.
vtkSmartPointer<vtkPolyData> volumeMesh(const Dump& dump, const TopTree& tree, size_t count) {
    const Box box = boxOf(dump);
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    std::vector<uint32_t> ids;
    for (uint32_t i = 0; i < count; ++i) {
        const size_t first = 4 * size_t(tree.volumes[i].caster);
        for (const Polygon& face :
             clippedVolume(box, dump.light(), {tree.planes[first], tree.planes[first + 1], tree.planes[first + 2], tree.planes[first + 3]})) {
            cells->InsertNextCell(int(face.size()));
            for (const glm::dvec3& corner : face) {
                const glm::dvec3 p = dump.world(corner);
                cells->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
            }
            ids.push_back(i);
        }
    }
    const auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points);
    mesh->SetPolys(cells);
    addVolumeArrays(*mesh->GetCellData(), tree.volumes, ids, true);
    addTreeFacts(*mesh, dump, tree);
    addFact(*mesh, "volumes_drawn", double(count));
    return mesh;
}

/// Every volume of the tree as a point at its caster's middle, joined to the one above.
vtkSmartPointer<vtkPolyData> nodeMesh(const Dump& dump, const TopTree& tree, std::span<const Corners> corners) {
    const auto volumeOf = tree.volumeOfCaster();
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    std::vector<uint32_t> ids;
    for (uint32_t i = 0; i < tree.volumes.size(); ++i) {
        const glm::dvec3 p = dump.world(placeOf(4 * tree.volumes[i].caster + 3, corners));
        points->InsertNextPoint(p.x, p.y, p.z);
        ids.push_back(i);
        if (i == 0) continue;
        const vtkIdType ends[2] = {vtkIdType(*volumeOf[tree.volumes[i].parent]), vtkIdType(i)};
        lines->InsertNextCell(2, ends);
    }
    const auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points);
    mesh->SetLines(lines);
    addVolumeArrays(*mesh->GetPointData(), tree.volumes, ids, true);
    addTreeFacts(*mesh, dump, tree);
    return mesh;
}

std::string leftOut(const TopTree& tree, size_t drawn) {
    if (drawn == tree.volumes.size()) return fmt::format("all {} shadow volumes of the tree", grouped(drawn));
    return fmt::format("drawing {} of {} shadow volumes: those nearest to the root (--limit)", grouped(drawn), grouped(tree.volumes.size()));
}

void addNotes(Picture& picture, const Dump& dump, const TopTree& tree, const TreeStatistics& statistics, size_t drawn) {
    picture.note(leftOut(tree, drawn));
    picture.note(
        fmt::format("{} casters, {} of them in the tree; depth {:.1f} on average, {} at most; {:.1f} % of the links lead to an intersection child; "
                    "{:.1f} visited nodes a sample",
                    grouped(tree.casters), grouped(tree.volumes.size()), statistics.meanDepth, statistics.deepest,
                    100 * statistics.intersectionShare(), double(statistics.visits) / double(std::max<uint64_t>(1, statistics.samples))));
    picture.note(fmt::format("settings: {}; clipped to the box of the casters, large ones more transparent; the yellow ball is the light",
                             dump.record().value("settings", nlohmann::json()).dump()));
}

/// The way of the traced query, visit by visit.
void showPath(const Options& options, const Dump& dump, const TopTree& tree, std::span<const Corners> corners) {
    const QueryPath path = QueryPath::read(dump, tree);
    const std::array paths{path};
    Picture picture(options.size,
                    fmt::format("query of pixel {}, {} ({}): {}", path.pixel.x, path.pixel.y, path.inShadow ? "in shadow" : "lit", dump.title()),
                    true);
    addScene(picture.panel(0), dump, corners, 0.25);
    addBall(picture.panel(0), dump.world(glm::dvec3(path.sample)), 0.008 * glm::length(dump.high() - dump.low()) * dump.metres(), kVermilion);
    const int last = int(path.visits.size());
    const auto colours = numberColours(0, last);
    picture.legend(0, *colours, "visit");
    std::vector<vtkSmartPointer<vtkActor>> actors;
    const auto upTo = [&](int steps) {
        for (const auto& actor : actors) picture.panel(0).RemoveActor(actor);
        actors = addPath(picture.panel(0), dump, path, corners, *colours, size_t(steps));
    };
    upTo(last);
    picture.lookAt(dump, options.view, boxOf(paths, corners));
    picture.show({"visited nodes that are drawn", 1, std::max(2, last), last, [&](int steps) { upTo(std::min(steps, last)); }}, options.closeAfter);
}

void show(const Options& options, const Dump& dump, const TopTree& tree, std::span<const Corners> corners, size_t drawn) {
    if (dump.isTraced()) return showPath(options, dump, tree, corners);
    Picture picture(options.size, "TOP tree: " + dump.title(), true);
    const Coloring coloring = coloringOf(options.color, std::span(tree.volumes).first(drawn));
    addScene(picture.panel(0), dump, corners, 0.25);
    vtkSmartPointer<vtkActor> volumes;
    const auto upTo = [&](int depth) {
        const size_t count = size_t(std::partition_point(tree.volumes.begin(), tree.volumes.begin() + ptrdiff_t(drawn),
                                                         [&](const Volume& v) { return int(v.depth) <= depth; }) -
                                    tree.volumes.begin());
        if (volumes) picture.panel(0).RemoveActor(volumes);
        const auto mesh = volumeMesh(dump, tree, count);
        fade(*mesh, dump, corners, coloring);
        volumes = addMesh(picture.panel(0), *mesh, {}, "drawn");
    };
    const int deepest = drawn > 0 ? int(tree.volumes[drawn - 1].depth) : 0;
    upTo(deepest);
    addLegend(picture, 0, options.color, coloring);
    picture.note(leftOut(tree, drawn));
    picture.lookAt(dump, options.view, boxOf(dump));
    picture.show({"deepest level that is drawn", 0, std::max(1, deepest), deepest, upTo}, options.closeAfter);
}

void writeBytes(const std::filesystem::path& path, const std::string& bytes) {
    host::AtomicFile file(path);
    file.stream() << bytes;
    file.commit();
}

/// Of one sample: the dumps must hold traces of the same pixel, and one tree, or the panels would not compare.
std::vector<QueryPath> pathsOf(std::span<const Dump> dumps, const TopTree& tree) {
    std::vector<QueryPath> paths;
    for (const Dump& dump : dumps) {
        const TopTree own = TopTree::read(dump);
        if (dumps.size() > 1 && (own.root != tree.root || own.planes != tree.planes || dump.tracedPixel() != dumps.front().tracedPixel()))
            throw host::InputError(fmt::format("{}: not the same tree, or not the same traced pixel, as {}; make the dumps in one run", dump.name(),
                                               dumps.front().name()));
        paths.push_back(QueryPath::read(dump, own));
    }
    return paths;
}

void writePaths(const Options& options, std::span<const Dump> dumps, std::span<const QueryPath> paths, std::span<const Corners> corners) {
    for (size_t i = 0; i < paths.size(); ++i) writeFile(options.out / (dumps[i].name() + "-tree-path.vtp"), *pathMesh(dumps[i], paths[i], corners));
    const Dump& dump = dumps.front();
    const std::string title =
        fmt::format("queries of pixel {}, {} ({}): {}", paths[0].pixel.x, paths[0].pixel.y, paths[0].inShadow ? "in shadow" : "lit", dump.title());
    PictureSize size = options.size;
    size.columns = paths.size() > 1 ? 2 : 1;
    size.rows = int(paths.size() + 1) / size.columns - (paths.size() == 1 ? 1 : 0);
    Picture picture(size, title);
    drawPaths(picture, dump, paths, corners);
    picture.note(
        "tubes: from node to node in the order of the visits; a lateral plane stands at the middle of its edge, a cap at the middle of its caster");
    picture.note("orange: from the stack; vermilion: back by an ancestor link; vermilion ball: the sample; yellow ball: the light");
    picture.lookAt(dump, options.view, boxOf(paths, corners));
    picture.writePng(options.out / (dump.name() + "-tree-path.png"));
    writeBytes(options.out / (dump.name() + "-tree-steps.png"), drawPng(stepsFigure(title, paths)));
}

}  // namespace

void viewTree(const Options& options) {
    std::vector<Dump> dumps;
    for (const auto& path : options.dumps) dumps.push_back(Dump::load(path));
    const Dump& dump = dumps.front();
    const TopTree tree = TopTree::read(dump);
    const std::vector<Corners> corners = cornersOf(dump);
    const TreeStatistics statistics = statisticsOf(dump, tree);
    if (statistics.visits != dump.counter("visited_nodes"))
        throw host::InputError(fmt::format(
            "{}: the visits of the tree's nodes add up to {}, and the record counted {}: a part of the dump is damaged, or of another run",
            dump.name(), statistics.visits, dump.counter("visited_nodes")));
    const size_t drawn = std::min<size_t>(options.limit, tree.volumes.size());
    if (options.interactive) return show(options, dump, tree, corners, drawn);

    const std::vector<QueryPath> paths = dumps.size() > 1 || dump.isTraced() ? pathsOf(dumps, tree) : std::vector<QueryPath>();
    host::makeFolder(options.out);
    const auto mesh = volumeMesh(dump, tree, drawn);
    writeFile(options.out / (dump.name() + "-tree-volumes.vtp"), *mesh);
    writeFile(options.out / (dump.name() + "-tree-nodes.vtp"), *nodeMesh(dump, tree, corners));
    writeBytes(options.out / (dump.name() + "-tree-statistics.json"), statistics.json().dump(1) + '\n');
    writeBytes(options.out / (dump.name() + "-tree-statistics.png"), drawPng(statisticsFigure(dump, statistics)));
    if (!paths.empty()) writePaths(options, dumps, paths, corners);
    Picture picture(options.size, "TOP tree: " + dump.title());
    const Coloring coloring = coloringOf(options.color, std::span(tree.volumes).first(drawn));
    addScene(picture.panel(0), dump, corners, 0.25);
    fade(*mesh, dump, corners, coloring);
    addMesh(picture.panel(0), *mesh, {}, "drawn");
    addLegend(picture, 0, options.color, coloring);
    addNotes(picture, dump, tree, statistics, drawn);
    picture.lookAt(dump, options.view, boxOf(dump));
    picture.writePng(options.out / fmt::format("{}-tree-{}.png", dump.name(), options.color));
    fmt::print("{}: {}\n", dump.title(), leftOut(tree, drawn));
}

}  // namespace gno::viz
