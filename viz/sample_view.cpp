// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cstdio>
#include <map>

#include "host_min/error.hpp"
#include "host_min/output/atomic_file.hpp"
#include "viz/files.hpp"
#include "viz/views.hpp"
#include "viz/wrong_samples.hpp"

namespace gno::viz {
namespace {

const std::vector<Kind> kErrorKinds{{"leak: lit, should be in shadow", kVermilion}, {"false dark", kBlue}};

vtkSmartPointer<vtkPolyData> pointMesh(const Dump& dump, const WrongSamples& wrong) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> vertices;
    std::vector<uint32_t> error, caster, own, plane, pixel;
    std::vector<float> distance;
    for (const WrongSample& sample : wrong.samples) {
        const glm::dvec3 p = dump.world(glm::dvec3(sample.position));
        const vtkIdType id = points->InsertNextPoint(p.x, p.y, p.z);
        vertices->InsertNextCell(1, &id);
        error.push_back(sample.isLeak ? 0 : 1);
        caster.push_back(sample.caster);
        own.push_back(sample.own);
        plane.push_back(sample.plane);
        distance.push_back(float(sample.distance));
        pixel.insert(pixel.end(), {sample.pixel.x, sample.pixel.y});
    }
    const auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points);
    mesh->SetVerts(vertices);
    for (const auto& [name, values] : {std::pair("error", &error), std::pair("caster", &caster), std::pair("own", &own), std::pair("plane", &plane)})
        mesh->GetPointData()->AddArray(array(name, "", std::span<const uint32_t>(*values)));
    mesh->GetPointData()->AddArray(array("distance", "m", std::span<const float>(distance)));
    mesh->GetPointData()->AddArray(array("pixel", "pixels", std::span<const uint32_t>(pixel), 2));
    addFact(*mesh, "title", dump.title());
    addFact(*mesh, "checked", double(wrong.checked));
    addFact(*mesh, "wrong", double(wrong.wrong));
    addFact(*mesh, "leaks", double(wrong.leaks));
    addFact(*mesh, "errors", "0 leak: lit and should be in shadow; 1 false dark");
    return mesh;
}

/// From an edge of a caster away from the light, as far as the farthest sample that it decided; a caster's own plane is a triangle a quarter larger.
/// Cell arrays: caster, plane, samples.
vtkSmartPointer<vtkPolyData> planeMesh(const Dump& dump, const WrongSamples& wrong, std::span<const Corners> corners) {
    struct Use {
        double reach = -1e30;  ///< depth of the farthest sample, away from the light
        uint32_t samples = 0;
    };
    std::map<std::pair<uint32_t, uint32_t>, Use> uses;
    const glm::dvec4 light(dump.light());
    const auto awayAt = [&](glm::dvec3 p) { return glm::normalize(light.w != 0 ? p - glm::dvec3(light) : -glm::dvec3(light)); };
    const auto depthOf = [&](glm::dvec3 p) { return light.w != 0 ? glm::length(p - glm::dvec3(light)) : glm::dot(p, awayAt(p)); };
    for (const WrongSample& sample : wrong.samples) {
        Use& use = uses[{sample.caster, sample.plane}];
        use.reach = std::max(use.reach, depthOf(glm::dvec3(sample.position)));
        ++use.samples;
    }
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    std::vector<uint32_t> caster, plane, samples;
    const auto add = [&](glm::dvec3 onGrid) {
        const glm::dvec3 p = dump.world(onGrid);
        cells->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
    };
    for (const auto& [which, use] : uses) {
        const Corners& t = corners[which.first];
        const auto beyond = [&](glm::dvec3 p) { return p + std::max(0.0, use.reach - depthOf(p)) * awayAt(p); };
        if (which.second == 3) {
            cells->InsertNextCell(3);
            const glm::dvec3 middle = (glm::dvec3(t[0]) + glm::dvec3(t[1]) + glm::dvec3(t[2])) / 3.0;
            for (const glm::vec3& corner : t) add(middle + 1.25 * (glm::dvec3(corner) - middle));
        } else {
            const glm::dvec3 a(t[which.second]), b(t[(which.second + 1) % 3]);
            cells->InsertNextCell(4);
            for (const glm::dvec3& p : {a, b, beyond(b), beyond(a)}) add(p);
        }
        caster.push_back(which.first);
        plane.push_back(which.second);
        samples.push_back(use.samples);
    }
    const auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points);
    mesh->SetPolys(cells);
    for (const auto& [name, values] : {std::pair("caster", &caster), std::pair("plane", &plane), std::pair("samples", &samples)})
        mesh->GetCellData()->AddArray(array(name, "", std::span<const uint32_t>(*values)));
    addFact(*mesh, "title", dump.title());
    addFact(*mesh, "planes", "0..2 lateral, through the light and edge ab, bc, ca; 3 the caster's own");
    return mesh;
}

std::vector<uint32_t> castersOf(const WrongSamples& wrong) {
    std::vector<uint32_t> casters;
    for (const WrongSample& sample : wrong.samples) casters.push_back(sample.caster);
    std::sort(casters.begin(), casters.end());
    casters.erase(std::unique(casters.begin(), casters.end()), casters.end());
    return casters;
}

std::string leftOut(const WrongSamples& wrong) {
    std::string all = fmt::format("{} of {} samples are wrong: {} leaks, {} false dark", grouped(wrong.wrong), grouped(wrong.checked),
                                  grouped(wrong.leaks), grouped(wrong.wrong - wrong.leaks - wrong.unknown));
    if (wrong.unknown > 0) all += fmt::format(", {} without an answer", grouped(wrong.unknown));
    if (wrong.samples.size() == wrong.wrong) return all;
    return fmt::format("{}; drawing {} of them, leaks first (--limit)", all, grouped(wrong.samples.size()));
}

/// The wrong sample that lies farthest from the plane that decided it, with its neighbourhood.
const WrongSample& worstOf(const WrongSamples& wrong) {
    return *std::max_element(wrong.samples.begin(), wrong.samples.end(),
                             [](const WrongSample& a, const WrongSample& b) { return std::abs(a.distance) < std::abs(b.distance); });
}

struct Meshes {
    vtkSmartPointer<vtkPolyData> points, planes, casters;
    std::vector<uint32_t> indices;  ///< of the casters
};

void draw(vtkRenderer& panel, const Dump& dump, const Meshes& meshes, std::span<const Corners> corners, const std::string& color,
          vtkLookupTable& table) {
    addScene(panel, dump, corners, 0.3, meshes.indices);
    if (meshes.points->GetNumberOfPoints() == 0) return;
    addMesh(panel, *meshes.planes, {.colour = kYellow, .opacity = 0.3, .lit = false});
    addMesh(panel, *meshes.casters, {.colour = kOrange, .opacity = 0.6, .lit = false});
    addMesh(panel, *meshes.points, {.lit = false, .pointSize = 7}, color == "plane" ? "plane" : "error", &table);
}

}  // namespace

void viewSamples(const Options& options) {
    if (options.dumps.size() > 1) throw host::InputError("samples: one dump at a time");
    const Dump dump = Dump::load(options.dumps.front());
    const std::vector<Corners> corners = cornersOf(dump);
    const WrongSamples wrong = wrongSamplesOf(dump, corners, options.limit);
    const std::vector<uint32_t> casters = castersOf(wrong);
    const Meshes meshes{pointMesh(dump, wrong), planeMesh(dump, wrong, corners),
                        casters.empty() ? vtkSmartPointer<vtkPolyData>::New() : meshOf(dump, corners, casters), casters};
    static const std::vector<Kind> planeKinds{
        {"plane through edge ab", kVermilion}, {"through bc", kBlue}, {"through ca", kGreen}, {"the caster's own", kPurple}};
    const std::vector<Kind>& kinds = options.color == "plane" ? planeKinds : kErrorKinds;
    const auto table = kindColours(kinds);
    const std::string title = "wrong samples: " + dump.title();

    PictureSize size = options.size;
    size.columns = options.interactive || wrong.samples.empty() ? 1 : 2;
    if (!options.interactive) {
        host::makeFolder(options.out);
        writeFile(options.out / (dump.name() + "-samples.vtp"), *meshes.points);
        writeFile(options.out / (dump.name() + "-samples-planes.vtp"), *meshes.planes);
        writeFile(options.out / (dump.name() + "-samples-casters.vtp"), *meshes.casters);
    }
    Picture picture(size, title, options.interactive);
    for (int panel = 0; panel < size.columns; ++panel) draw(picture.panel(panel), dump, meshes, corners, options.color, *table);
    picture.legend(0, kinds);
    picture.lookAt(dump, options.view, boxOf(dump));
    picture.note(leftOut(wrong));
    picture.note(
        "orange: the caster a sample turned on (a leak: one that shadows it; false dark: the one whose shadow volume is nearest); yellow: its plane "
        "nearest to the sample");
    const auto focus = [&](const WrongSample& sample, int panel) {
        const double radius = std::max(0.02 * glm::length(dump.high() - dump.low()), 1.5 * std::abs(sample.distance) / dump.metres());
        const glm::dvec3 at(sample.position);
        picture.lookAt(dump, View::overview, {at - radius, at + radius}, {panel});
    };
    if (options.interactive) {
        const int last = std::max<int>(1, int(wrong.samples.size()));
        picture.show({"wrong sample (0: all)", 0, last, 0,
                      [&](int number) {
                          if (number == 0 || wrong.samples.empty())
                              picture.lookAt(dump, options.view, boxOf(dump));
                          else
                              focus(wrong.samples[size_t(number - 1)], 0);
                      }},
                     options.closeAfter);
        return;
    }
    if (!wrong.samples.empty()) {
        const WrongSample& worst = worstOf(wrong);
        focus(worst, 1);
        picture.panelTitle(0, "all");
        picture.panelTitle(
            1, fmt::format("pixel {}, {}: {}, {:.2g} m {} plane {} of caster {}", worst.pixel.x, worst.pixel.y, worst.isLeak ? "leak" : "false dark",
                           std::abs(worst.distance), worst.distance > 0 ? "outside" : "inside", worst.plane, worst.caster));
    }
    picture.note("settings: " + dump.record().value("settings", nlohmann::json()).dump());
    picture.writePng(options.out / (dump.name() + "-samples.png"));
    fmt::print("{}: {}\n", dump.title(), leftOut(wrong));
}

}  // namespace gno::viz
