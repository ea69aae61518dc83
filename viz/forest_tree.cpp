// SPDX-License-Identifier: MIT
#include "viz/forest_tree.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <algorithm>
#include <numeric>

#include "host_min/error.hpp"
#include "viz/files.hpp"

namespace gno::viz {
namespace {

void addFacts(vtkPolyData& mesh, const Dump& dump, const CellTree& tree, size_t drawn) {
    addFact(mesh, "title", dump.title());
    addFact(mesh, "cell", tree.cell);
    addFact(mesh, "volumes_in_tree", double(tree.volumes.size()));
    addFact(mesh, "volumes_drawn", double(drawn));
    addFact(mesh, "kept_by_margins", double(tree.byMargins));
    addFact(mesh, "links", kLinksFact);
}

void addArrays(vtkPolyData& mesh, const CellTree& tree, std::span<const uint32_t> ids) {
    addVolumeArrays(*mesh.GetCellData(), tree.volumes, ids, false);
    std::vector<uint32_t> parents;
    for (const uint32_t id : ids) parents.push_back(tree.volumes[id].parent);
    mesh.GetCellData()->AddArray(array("parent", "", std::span<const uint32_t>(parents)));
}

/// To the farthest view sample in the cell; where it has none, to the far side of the scene.
double farthestOf(const Dump& dump, const Forest& forest, uint32_t cell, double outside) {
    struct Sample {
        glm::vec3 position;
        uint32_t own;
    };
    if (forest.cells[cell].samples == 0) return outside;
    double farthest = -1e30;
    for (const Sample& sample : dump.readPerPixel<Sample>("samples"))
        if (sample.own <= GNO_NO_CASTER && forest.cellAt(sample.position) == cell)
            farthest = std::max(farthest, forest.depthOf(forest.faceOf(cell), glm::dvec3(sample.position)));
    return farthest;
}

glm::dvec3 onEdge(const CellEdge& edge, double depth) { return edge.at + depth * edge.along; }

}  // namespace

CellTree CellTree::read(const Dump& dump, const Forest& forest, std::span<const Corners> corners, uint32_t cell) {
    if (cell >= forest.cells.size())
        throw host::InputError(fmt::format("--cell {}: {} has {} cells (0..{})", cell, dump.name(), forest.cells.size(), forest.cells.size() - 1));
    if (forest.cells[cell].casters == 0)
        throw host::InputError(fmt::format("--cell {}: it keeps no casters; cell {} keeps most of them, {}", cell, forest.fullestCell(),
                                           forest.cells[forest.fullestCell()].casters));
    CellTree tree;
    tree.cell = cell;
    tree.volumes = forest.treeOf(dump, cell);
    const auto sides = forest.sidesOf(cell);
    const bool isPoint = dump.light().w != 0;
    const Box scene = boxOf(dump);
    double least = 1e30, greatest = -1e30;
    for (int corner = 0; corner < 8; ++corner) {
        const double depth = forest.depthOf(forest.faceOf(cell), {corner & 1 ? scene.high.x : scene.low.x, corner & 2 ? scene.high.y : scene.low.y,
                                                                  corner & 4 ? scene.high.z : scene.low.z});
        least = std::min(least, depth);
        greatest = std::max(greatest, depth);
    }
    tree.nearest = isPoint ? 0 : least;
    tree.farthest = farthestOf(dump, forest, cell, greatest);
    const auto edges = forest.edgesOf(cell);
    tree.box = {onEdge(edges[0], tree.farthest), onEdge(edges[0], tree.farthest)};
    const auto widen = [&](const glm::dvec3& p) { tree.box = {glm::min(tree.box.low, p), glm::max(tree.box.high, p)}; };
    for (const CellEdge& edge : edges) widen(onEdge(edge, tree.farthest));
    const glm::dvec3 axis = forest.axisOf(forest.faceOf(cell));
    const std::array end{glm::dvec4(axis, -glm::dot(axis, onEdge(edges[0], tree.farthest)))};
    for (const Volume& volume : tree.volumes) {
        const Corners& t = corners[volume.caster];
        Polygon part = clipped({glm::dvec3(t[0]), glm::dvec3(t[1]), glm::dvec3(t[2])}, sides);
        tree.byMargins += part.empty();
        tree.parts.push_back(clipped(std::move(part), end));
        for (const glm::dvec3& p : tree.parts.back()) widen(p);
    }
    return tree;
}

std::string CellTree::numbers(const Forest& forest) const {
    const ForestCell& own = forest.cells[cell];
    return fmt::format(
        "{} casters, {} of them in its tree ({} by the margins of the cell alone), depth {} at most; {} samples, {:.1f} visited nodes each, {} at "
        "most",
        grouped(own.casters), grouped(own.volumes), grouped(byMargins), own.deepest, grouped(own.samples), own.visitsPerSample(),
        grouped(own.mostVisits));
}

vtkSmartPointer<vtkPolyData> casterMesh(const Dump& dump, const CellTree& tree, std::span<const Corners> corners, size_t count) {
    std::vector<uint32_t> casters, ids(count);
    std::iota(ids.begin(), ids.end(), 0u);
    for (const uint32_t id : ids) casters.push_back(tree.volumes[id].caster);
    const auto mesh = meshOf(dump, corners, casters);
    addArrays(*mesh, tree, ids);
    addFacts(*mesh, dump, tree, count);
    return mesh;
}

vtkSmartPointer<vtkPolyData> partMesh(const Dump& dump, const CellTree& tree, size_t count) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    std::vector<uint32_t> ids;
    for (uint32_t i = 0; i < count; ++i) {
        if (tree.parts[i].empty()) continue;
        cells->InsertNextCell(int(tree.parts[i].size()));
        for (const glm::dvec3& corner : tree.parts[i]) {
            const glm::dvec3 p = dump.world(corner);
            cells->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
        }
        ids.push_back(i);
    }
    const auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points);
    mesh->SetPolys(cells);
    addArrays(*mesh, tree, ids);
    addFacts(*mesh, dump, tree, count);
    return mesh;
}

vtkSmartPointer<vtkPolyData> pyramidMesh(const Dump& dump, const Forest& forest, const CellTree& tree) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    const auto edges = forest.edgesOf(tree.cell);
    for (const double depth : {tree.nearest, tree.farthest})
        for (const CellEdge& edge : edges) {
            const glm::dvec3 p = dump.world(onEdge(edge, depth));
            points->InsertNextPoint(p.x, p.y, p.z);
        }
    for (vtkIdType i = 0; i < 4; ++i) {
        const vtkIdType next = (i + 1) % 4;
        for (const auto& [from, to] : {std::pair(i, next), std::pair(i + 4, next + 4), std::pair(i, i + 4)}) {
            const vtkIdType ends[2] = {from, to};
            lines->InsertNextCell(2, ends);
        }
    }
    const auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points);
    mesh->SetLines(lines);
    addFact(*mesh, "title", dump.title());
    addFact(*mesh, "cell", tree.cell);
    return mesh;
}

}  // namespace gno::viz
