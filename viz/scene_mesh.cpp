// SPDX-License-Identifier: MIT
#include "viz/scene_mesh.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <algorithm>
#include <numeric>

#include "viz/files.hpp"

namespace gno::viz {

std::vector<Corners> cornersOf(const Dump& dump) { return dump.read<Corners>("casters", dump.casterCount()); }

vtkSmartPointer<vtkPolyData> meshOf(const Dump& dump, std::span<const Corners> corners, std::span<const uint32_t> which) {
    std::vector<uint32_t> all;
    if (which.empty()) {
        all.resize(corners.size());
        std::iota(all.begin(), all.end(), 0u);
        which = all;
    }
    vtkNew<vtkPoints> points;
    points->SetNumberOfPoints(3 * vtkIdType(which.size()));
    vtkNew<vtkCellArray> cells;
    vtkIdType next = 0;
    for (const uint32_t caster : which) {
        cells->InsertNextCell(3);
        for (const glm::vec3& corner : corners[caster]) {
            const glm::dvec3 p = dump.world(corner);
            cells->InsertCellPoint(next);
            points->SetPoint(next++, p.x, p.y, p.z);
        }
    }
    const auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points);
    mesh->SetPolys(cells);
    mesh->GetCellData()->AddArray(array("caster", "", which));
    return mesh;
}

std::vector<uint32_t> largestCasters(std::span<const Corners> corners, size_t count) {
    std::vector<uint32_t> order(corners.size());
    std::iota(order.begin(), order.end(), 0u);
    if (order.size() <= count) return order;
    std::vector<float> areas;
    for (const Corners& t : corners) areas.push_back(glm::length(glm::cross(t[1] - t[0], t[2] - t[0])));
    std::nth_element(order.begin(), order.begin() + ptrdiff_t(count), order.end(), [&](uint32_t a, uint32_t b) { return areas[a] > areas[b]; });
    order.resize(count);
    return order;
}

Box boxOf(const Dump& dump) {
    const glm::dvec3 room(1e-3 * glm::length(dump.high() - dump.low()) + 1e-9);
    return {dump.low() - room, dump.high() + room};
}

glm::dvec3 lightMarkOf(const Dump& dump) {
    const glm::dvec4 light(dump.light());
    if (light.w != 0) return dump.world(glm::dvec3(light));
    return dump.world((dump.low() + dump.high()) / 2.0 + glm::normalize(glm::dvec3(light)) * 0.55 * glm::length(dump.high() - dump.low()));
}

}  // namespace gno::viz
