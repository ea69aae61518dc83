// SPDX-License-Identifier: MIT
#include "viz/volume_look.hpp"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "viz/files.hpp"

namespace gno::viz {
namespace {

const std::vector<Kind> kLinkKinds{{"root", kDark}, {"positive child", kBlue}, {"positive child of a cap", kSky}, {"intersection child", kOrange}};

}  // namespace

Coloring coloringOf(const std::string& color, std::span<const Volume> drawn) {
    if (color == "kind") return {"link", "", kindColours(kLinkKinds)};
    const auto range = [&](auto value) {
        const auto [least, most] =
            std::minmax_element(drawn.begin(), drawn.end(), [&](const Volume& a, const Volume& b) { return value(a) < value(b); });
        return std::pair(double(value(*least)), double(value(*most)));
    };
    if (drawn.empty()) return {"depth", "volumes above", numberColours(0, 1)};
    if (color == "distance") {
        const auto [least, most] = range([](const Volume& v) { return v.leastDistance; });
        return {"least_distance", "least distance\nin the subtree [m]", numberColours(least, most)};
    }
    if (color == "visits") {
        const auto [least, most] = range([](const Volume& v) { return v.visits; });
        return {"visits", "visits\nin the frame", numberColours(std::max(1.0, least), std::max(10.0, most), true)};
    }
    const auto [least, most] = range([](const Volume& v) { return v.depth; });
    return {"depth", "depth in the tree\n[volumes above]", numberColours(least, most)};
}

void addLegend(Picture& picture, int panel, const std::string& color, const Coloring& coloring) {
    if (color == "kind")
        picture.legend(panel, kLinkKinds);
    else
        picture.legend(panel, *coloring.table, coloring.title);
}

void addVolumeArrays(vtkDataSetAttributes& target, std::span<const Volume> volumes, std::span<const uint32_t> ids, bool visits) {
    const auto add = [&](const char* name, const char* unit, auto value) {
        std::vector<decltype(value(volumes[0]))> values;
        for (const uint32_t id : ids) values.push_back(value(volumes[id]));
        using T = typename decltype(values)::value_type;
        target.AddArray(array(name, unit, std::span<const T>(values)));
    };
    add("caster", "", [](const Volume& v) { return v.caster; });
    add("depth", "volumes above", [](const Volume& v) { return v.depth; });
    add("nodes_above", "nodes", [](const Volume& v) { return v.planesAbove; });
    add("link", "", [](const Volume& v) { return uint32_t(v.link); });
    add("least_distance", "m", [](const Volume& v) { return v.leastDistance; });
    if (visits) add("visits", "visits", [](const Volume& v) { return uint32_t(std::min<uint64_t>(v.visits, 0xFFFFFFFFu)); });
}

void fade(vtkPolyData& mesh, const Dump& dump, std::span<const Corners> corners, const Coloring& coloring) {
    const double diagonal = glm::length(dump.high() - dump.low());
    vtkDataArray& values = *mesh.GetCellData()->GetArray(coloring.array.c_str());
    vtkDataArray& casters = *mesh.GetCellData()->GetArray("caster");
    vtkNew<vtkUnsignedCharArray> drawn;
    drawn->SetName("drawn");
    drawn->SetNumberOfComponents(4);
    for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell) {
        const Corners& t = corners[size_t(casters.GetComponent(cell, 0))];
        const double size = std::sqrt(glm::length(glm::cross(t[1] - t[0], t[2] - t[0]))) / diagonal;
        const double opacity = std::clamp(0.02 / std::max(size, 1e-9), 0.05, 0.75);
        const unsigned char* colour = coloring.table->MapValue(values.GetComponent(cell, 0));
        const unsigned char rgba[4] = {colour[0], colour[1], colour[2], static_cast<unsigned char>(255 * opacity)};
        drawn->InsertNextTypedTuple(rgba);
    }
    mesh.GetCellData()->AddArray(drawn);
}

}  // namespace gno::viz
