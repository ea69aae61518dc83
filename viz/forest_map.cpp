// SPDX-License-Identifier: MIT
#include "viz/forest_map.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <functional>

#include "viz/files.hpp"

namespace gno::viz {
namespace {

constexpr glm::dvec3 kUnseen{0.93, 0.93, 0.94};

/// A face as one sees it from the light, looking along `forward`.
struct Tile {
    glm::dvec3 forward, right, up;
    glm::dvec2 middle;  ///< of the face on the map
};

/// By face: +x, -x, +y, -y, +z, -z. -z is in the middle of the cross, +z at its right end; neighbours on the map are neighbours around the light.
constexpr std::array<Tile, 6> kTiles{{{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {2, 0}},
                                      {{-1, 0, 0}, {0, 0, -1}, {0, 1, 0}, {-2, 0}},
                                      {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {0, 2}},
                                      {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}, {0, -2}},
                                      {{0, 0, 1}, {-1, 0, 0}, {0, 1, 0}, {4, 0}},
                                      {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0}}}};

/// Where a place on a face is on the map.
glm::dvec2 onMap(const Dump& dump, const Forest& forest, uint32_t face, glm::dvec2 place) {
    if (forest.grid.faces == 1) return (place - glm::dvec2(forest.grid.across.w, forest.grid.along.w)) * dump.metres();
    const Tile& tile = kTiles[face];
    const glm::dvec3 direction = forest.direction(face, place);
    return tile.middle + glm::dvec2(glm::dot(direction, tile.right), glm::dot(direction, tile.up));
}

struct Area {
    glm::dvec2 low, high;
};

Area areaOf(const Dump& dump, const Forest& forest, uint32_t face) {
    const uint32_t count = forest.grid.resolution * forest.grid.resolution;
    const glm::dvec2 a = onMap(dump, forest, face, forest.cornerOf(face * count, 0)),
                     b = onMap(dump, forest, face, forest.cornerOf((face + 1) * count - 1, 2));
    return {glm::min(a, b), glm::max(a, b)};
}

/// Cells that are asked for.
vtkSmartPointer<vtkPolyData> cellsWhere(const Dump& dump, const Forest& forest, const std::function<bool(const ForestCell&)>& isDrawn) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> quads;
    std::vector<uint32_t> casters, volumes, deepest, samples, mostVisits;
    std::vector<float> visits;
    for (uint32_t i = 0; i < forest.cells.size(); ++i) {
        const ForestCell& cell = forest.cells[i];
        if (!isDrawn(cell)) continue;
        quads->InsertNextCell(4);
        for (uint32_t corner = 0; corner < 4; ++corner) {
            const glm::dvec2 p = onMap(dump, forest, forest.faceOf(i), forest.cornerOf(i, corner));
            quads->InsertCellPoint(points->InsertNextPoint(p.x, p.y, 0));
        }
        casters.push_back(cell.casters);
        volumes.push_back(cell.volumes);
        deepest.push_back(cell.deepest);
        samples.push_back(cell.samples);
        mostVisits.push_back(cell.mostVisits);
        visits.push_back(float(cell.visitsPerSample()));
    }
    const auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points);
    mesh->SetPolys(quads);
    for (const auto& [name, unit, values] :
         {std::tuple("casters", "casters", &casters), std::tuple("volumes", "volumes", &volumes), std::tuple("deepest", "volumes above", &deepest),
          std::tuple("samples", "samples", &samples), std::tuple("most_visits", "visits", &mostVisits)})
        mesh->GetCellData()->AddArray(array(name, unit, std::span<const uint32_t>(*values)));
    mesh->GetCellData()->AddArray(array("visits_per_sample", "visits", std::span<const float>(visits)));
    return mesh;
}

void addLabel(vtkRenderer& panel, const std::string& words, glm::dvec2 at, int size) {
    vtkNew<vtkTextActor> label;
    label->SetInput(words.c_str());
    label->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    label->GetPositionCoordinate()->SetValue(at.x, at.y, 0);
    label->GetTextProperty()->SetFontSize(size);
    label->GetTextProperty()->SetColor(kDark.r, kDark.g, kDark.b);
    label->GetTextProperty()->SetVerticalJustificationToTop();
    panel.AddViewProp(label);
}

void addOutline(vtkRenderer& panel, const Area& area) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell(5);
    for (int corner = 0; corner < 5; ++corner)
        lines->InsertCellPoint(points->InsertNextPoint(corner == 1 || corner == 2 ? area.high.x : area.low.x,
                                                       corner == 2 || corner == 3 ? area.high.y : area.low.y, 0));
    vtkNew<vtkPolyData> outline;
    outline->SetPoints(points);
    outline->SetLines(lines);
    addMesh(panel, *outline, {.colour = kDark, .lit = false, .lineWidth = 1.5});
}

/// Straight onto the map, its middle left of the legend.
void lookDown(vtkRenderer& panel, const Area& all) {
    const glm::dvec2 middle = (all.low + all.high) / 2.0, half = 0.54 * (all.high - all.low);
    const double* viewport = panel.GetViewport();
    const int* size = panel.GetVTKWindow()->GetSize();
    const double aspect = (viewport[2] - viewport[0]) * size[0] / ((viewport[3] - viewport[1]) * size[1]);
    vtkNew<vtkCamera> camera;
    camera->SetParallelProjection(1);
    camera->SetParallelScale(std::max(half.y, half.x / (0.85 * aspect)));
    camera->SetFocalPoint(middle.x, middle.y, 0);
    camera->SetPosition(middle.x, middle.y, 1);
    camera->SetViewUp(0, 1, 0);
    camera->SetWindowCenter(0.1, 0);
    panel.SetActiveCamera(camera);
}

}  // namespace

vtkSmartPointer<vtkPolyData> cellMesh(const Dump& dump, const Forest& forest) {
    const auto mesh = cellsWhere(dump, forest, [](const ForestCell&) { return true; });
    addFact(*mesh, "title", dump.title());
    addFact(*mesh, "resolution", forest.grid.resolution);
    addFact(*mesh, "pairs", double(forest.casterOfBlock.size()));
    addFact(*mesh, "used_cells", double(forest.used));
    addFact(*mesh, "volumes", double(forest.volumes));
    addFact(*mesh, "visits", double(forest.visits));
    return mesh;
}

void drawCells(Picture& picture, const Dump& dump, const Forest& forest, const std::string& color) {
    const bool byVisits = color == "visits";
    const auto isColoured = [&](const ForestCell& cell) { return cell.casters > 0 && (!byVisits || cell.samples > 0); };
    double least = 1e30, most = 1;
    for (const ForestCell& cell : forest.cells) {
        if (!isColoured(cell)) continue;
        const double value = std::max(1.0, byVisits ? cell.visitsPerSample() : double(cell.casters));
        least = std::min(least, value);
        most = std::max(most, value);
    }
    const auto table = numberColours(std::min(least, most), std::max(most, 10 * std::min(least, most)), true);
    vtkRenderer& panel = picture.panel(0);
    panel.UseFXAAOff();  // it would round the cells' corners
    addMesh(panel, *cellsWhere(dump, forest, isColoured), {.lit = false}, byVisits ? "visits_per_sample" : "casters", table);
    addMesh(panel, *cellsWhere(dump, forest, [&](const ForestCell& cell) { return !isColoured(cell) && cell.samples > 0; }),
            {.colour = kPale, .lit = false});
    addMesh(panel, *cellsWhere(dump, forest, [&](const ForestCell& cell) { return !isColoured(cell) && cell.samples == 0; }),
            {.colour = kUnseen, .lit = false});
    picture.legend(0, *table, byVisits ? "visited nodes\nof a sample, mean" : "casters\nof the cell");
    Area all = areaOf(dump, forest, 0);
    for (uint32_t face = 0; face < forest.grid.faces; ++face) {
        const Area area = areaOf(dump, forest, face);
        all = {glm::min(all.low, area.low), glm::max(all.high, area.high)};
        addOutline(panel, area);
        addLabel(panel, fmt::format(" {}", faceName(forest, face)), {area.low.x, area.high.y - 0.015 * (area.high.y - area.low.y)},
                 picture.panel(0).GetVTKWindow()->GetSize()[1] / 45);
    }
    lookDown(panel, all);
}

}  // namespace gno::viz
