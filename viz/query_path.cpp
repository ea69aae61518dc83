// SPDX-License-Identifier: MIT
#include "viz/query_path.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>

#include "glsl/core/shared_types.h"
#include "host_min/error.hpp"
#include "viz/files.hpp"

namespace gno::viz {

using host::InputError;

const std::vector<Kind>& stepKinds() {
    static const std::vector<Kind> kinds{{"root", kDark},
                                         {"negative (next plane)", kSky},
                                         {"positive child", kBlue},
                                         {"intersection child", kGreen},
                                         {"from the stack", kOrange},
                                         {"back by ancestor link", kVermilion},
                                         {"again without a stack", kPurple}};
    return kinds;
}

QueryPath QueryPath::read(const Dump& dump, const TopTree& tree) {
    if (!dump.isTraced()) throw InputError(fmt::format("{}: holds no trace; make it with --trace X,Y", dump.name()));
    QueryPath path{dump.technique(), dump.precision(), dump.tracedPixel()};
    const glm::uvec2 at = path.pixel;
    if (at.x >= dump.width() || at.y >= dump.height()) throw InputError(fmt::format("{}: the traced pixel is outside", dump.name()));
    const size_t pixel = size_t(at.y) * dump.width() + at.x;
    struct Sample {
        glm::vec3 position;
        uint32_t own;
    };
    path.sample = dump.readPerPixel<Sample>("samples")[pixel].position;
    path.inShadow = dump.readPerPixel<uint32_t>("visibility")[pixel] == GNO_VISIBILITY_SHADOW;
    const auto volumeOf = tree.volumeOfCaster();
    for (const glm::uvec2& entry : dump.read<glm::uvec2>("trace")) {
        if (entry.x >= 4 * tree.casters || !volumeOf[entry.x / 4] || entry.y >= stepKinds().size())
            throw InputError(fmt::format("{}: the trace visits node {}, which is not in the tree", dump.name(), entry.x));
        path.visits.push_back({entry.x, Step(entry.y), tree.volumes[*volumeOf[entry.x / 4]].planesAbove + entry.x % 4});
    }
    return path;
}

size_t QueryPath::count(Step step) const {
    return size_t(std::count_if(visits.begin(), visits.end(), [&](const Visit& visit) { return visit.step == step; }));
}

glm::dvec3 placeOf(uint32_t node, std::span<const Corners> corners) {
    const Corners& t = corners[node / 4];
    if (node % 4 == 3) return (glm::dvec3(t[0]) + glm::dvec3(t[1]) + glm::dvec3(t[2])) / 3.0;
    return (glm::dvec3(t[node % 4]) + glm::dvec3(t[(node % 4 + 1) % 3])) / 2.0;
}

vtkSmartPointer<vtkPolyData> pathMesh(const Dump& dump, const QueryPath& path, std::span<const Corners> corners) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    std::vector<uint32_t> order, node, caster, plane, step, depth;
    for (const Visit& visit : path.visits) {
        const glm::dvec3 p = dump.world(placeOf(visit.node, corners));
        const vtkIdType id = points->InsertNextPoint(p.x, p.y, p.z);
        if (id > 0) {
            const vtkIdType ends[2] = {id - 1, id};
            lines->InsertNextCell(2, ends);
        }
        order.push_back(uint32_t(id));
        node.push_back(visit.node);
        caster.push_back(visit.node / 4);
        plane.push_back(visit.node % 4);
        step.push_back(uint32_t(visit.step));
        depth.push_back(visit.depth);
    }
    const auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points);
    mesh->SetLines(lines);
    for (const auto& [name, unit, values] : {std::tuple("order", "visits", &order), std::tuple("node", "", &node), std::tuple("caster", "", &caster),
                                             std::tuple("plane", "", &plane), std::tuple("step", "", &step), std::tuple("depth", "nodes", &depth)})
        mesh->GetPointData()->AddArray(array(name, unit, std::span<const uint32_t>(*values)));
    mesh->GetCellData()->AddArray(array("step", "", std::span<const uint32_t>(step).subspan(std::min<size_t>(1, step.size()))));
    addFact(*mesh, "title", dump.title());
    addFact(*mesh, "visited_nodes", double(path.visits.size()));
    addFact(*mesh, "ancestor_jumps", double(path.count(Step::ancestor)));
    return mesh;
}

}  // namespace gno::viz
