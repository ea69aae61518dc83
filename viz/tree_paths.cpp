// SPDX-License-Identifier: MIT
#include "viz/tree_paths.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTubeFilter.h>

#include <algorithm>
#include <set>

#include "viz/files.hpp"

namespace gno::viz {
namespace {

bool isJump(Step step) { return step == Step::pop || step == Step::ancestor || step == Step::restart; }

/// Tubes along the lines of a path whose step is (or is not) a jump.
vtkSmartPointer<vtkPolyData> tubesOf(const Dump& dump, const QueryPath& path, std::span<const Corners> corners, size_t steps, bool jumps,
                                     double radius) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    std::vector<uint32_t> order, step;
    for (size_t i = 1; i < steps; ++i) {
        if (isJump(path.visits[i].step) != jumps) continue;
        const glm::dvec3 a = dump.world(placeOf(path.visits[i - 1].node, corners)), b = dump.world(placeOf(path.visits[i].node, corners));
        if (a == b) continue;
        const vtkIdType ends[2] = {points->InsertNextPoint(a.x, a.y, a.z), points->InsertNextPoint(b.x, b.y, b.z)};
        lines->InsertNextCell(2, ends);
        for (int end = 0; end < 2; ++end) {
            order.push_back(uint32_t(i));
            step.push_back(uint32_t(path.visits[i].step));
        }
    }
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->SetLines(lines);
    mesh->GetPointData()->AddArray(array("order", "visits", std::span<const uint32_t>(order)));
    mesh->GetPointData()->AddArray(array("step", "", std::span<const uint32_t>(step)));
    vtkNew<vtkTubeFilter> tubes;
    tubes->SetInputData(mesh);
    tubes->SetRadius(radius);
    tubes->SetNumberOfSides(8);
    tubes->CappingOn();
    tubes->Update();
    return tubes->GetOutput();
}

}  // namespace

std::vector<vtkSmartPointer<vtkActor>> addPath(vtkRenderer& panel, const Dump& dump, const QueryPath& path, std::span<const Corners> corners,
                                               vtkLookupTable& colours, size_t steps) {
    std::vector<uint32_t> casters, order;
    std::set<uint32_t> seen;
    for (size_t i = 0; i < steps; ++i)
        if (seen.insert(path.visits[i].node / 4).second) {
            casters.push_back(path.visits[i].node / 4);
            order.push_back(uint32_t(i));
        }
    std::vector<vtkSmartPointer<vtkActor>> actors;
    const double size = glm::length(dump.high() - dump.low()) * dump.metres();
    if (!casters.empty()) {
        const auto mesh = meshOf(dump, corners, casters);
        mesh->GetCellData()->AddArray(array("order", "visits", std::span<const uint32_t>(order)));
        actors.push_back(addMesh(panel, *mesh, {.outlines = true, .lit = false, .lineWidth = 1.5}, "order", &colours));
    }
    actors.push_back(addMesh(panel, *tubesOf(dump, path, corners, steps, false, 0.0022 * size), {}, "order", &colours));
    static const auto kinds = kindColours(stepKinds());
    actors.push_back(addMesh(panel, *tubesOf(dump, path, corners, steps, true, 0.0014 * size), {.opacity = 0.9}, "step", kinds));
    return actors;
}

Box boxOf(std::span<const QueryPath> paths, std::span<const Corners> corners) {
    const glm::dvec3 sample(paths.front().sample);
    std::vector<double> away;
    for (const QueryPath& path : paths)
        for (const Visit& visit : path.visits) away.push_back(glm::length(placeOf(visit.node, corners) - sample));
    std::sort(away.begin(), away.end());
    const double radius = std::max(1e-6, away[away.size() * 9 / 10]);
    return {sample - radius, sample + radius};
}

void drawPaths(Picture& picture, const Dump& dump, std::span<const QueryPath> paths, std::span<const Corners> corners) {
    size_t longest = 1;
    for (const QueryPath& path : paths) longest = std::max(longest, path.visits.size());
    const auto colours = numberColours(0, double(longest));
    const double size = glm::length(dump.high() - dump.low()) * dump.metres();
    for (size_t i = 0; i < paths.size(); ++i) {
        vtkRenderer& panel = picture.panel(int(i));
        addScene(panel, dump, corners, 0.18);
        (void)addPath(panel, dump, paths[i], corners, *colours, paths[i].visits.size());
        addBall(panel, dump.world(glm::dvec3(paths[i].sample)), 0.008 * size, kVermilion);
        picture.panelTitle(int(i), fmt::format("{}: {} visited nodes, {} from the stack, {} back by ancestor link", paths[i].technique,
                                               paths[i].visits.size(), paths[i].count(Step::pop), paths[i].count(Step::ancestor)));
        picture.legend(int(i), *colours, "visit");
    }
}

}  // namespace gno::viz
