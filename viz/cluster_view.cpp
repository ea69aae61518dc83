// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cstdio>

#include "host_min/error.hpp"
#include "host_min/output/atomic_file.hpp"
#include "host_min/output/heatmap.hpp"
#include "host_min/output/png.hpp"
#include "viz/cluster_tree.hpp"
#include "viz/files.hpp"
#include "viz/views.hpp"

namespace gno::viz {
namespace {

const std::vector<Kind> kNodeKinds{{"occupied", kSky}, {"accepted: wholly in a shadow volume", kVermilion}};
enum class Shape { cell, box };

std::array<glm::dvec3, 8> cornersOfNode(const ClusterTree& tree, const ClusterNode& node, Shape shape) {
    if (shape == Shape::cell) return tree.cellOf(node);
    std::array<glm::dvec3, 8> corners;
    for (size_t i = 0; i < 8; ++i)
        corners[i] = {i & 1 ? node.high.x : node.low.x, i & 2 ? node.high.y : node.low.y, i & 4 ? node.high.z : node.low.z};
    return corners;
}

/// From the viewer's eye (orthographic: its plane) to the node's nearest corner, along the viewing direction, metres.
float distanceOf(const Dump& dump, const ClusterTree& tree, const ClusterNode& node) {
    double least = 1e30;
    for (const glm::dvec3& corner : tree.cellOf(node))
        least = std::min(least, glm::dot(corner - glm::dvec3(tree.frame.origin), glm::dvec3(tree.frame.forward)));
    return float(least * dump.metres());
}

/// Six faces a node. Cell arrays: level, key, accepted, distance.
vtkSmartPointer<vtkPolyData> nodeMesh(const Dump& dump, const ClusterTree& tree, std::span<const ClusterNode> nodes, Shape shape) {
    constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    std::vector<uint32_t> level, key, accepted;
    std::vector<float> distance;
    for (const ClusterNode& node : nodes) {
        vtkIdType first = -1;
        for (const glm::dvec3& corner : cornersOfNode(tree, node, shape)) {
            const glm::dvec3 p = dump.world(corner);
            const vtkIdType id = points->InsertNextPoint(p.x, p.y, p.z);
            if (first < 0) first = id;
        }
        for (const auto& face : kFaces) {
            cells->InsertNextCell(4);
            for (const int corner : face) cells->InsertCellPoint(first + corner);
            level.push_back(node.level);
            key.push_back(node.key);
            accepted.push_back(node.accepted);
            distance.push_back(distanceOf(dump, tree, node));
        }
    }
    const auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points);
    mesh->SetPolys(cells);
    mesh->GetCellData()->AddArray(array("level", "", std::span<const uint32_t>(level)));
    mesh->GetCellData()->AddArray(array("key", "", std::span<const uint32_t>(key)));
    mesh->GetCellData()->AddArray(array("accepted", "", std::span<const uint32_t>(accepted)));
    mesh->GetCellData()->AddArray(array("distance", "m", std::span<const float>(distance)));
    addFact(*mesh, "title", dump.title());
    addFact(*mesh, "nodes", double(nodes.size()));
    addFact(*mesh, "levels", tree.layout.levels);
    return mesh;
}

/// Viewer and clusters.
Box focusOf(const ClusterTree& tree) {
    Box box{glm::dvec3(tree.frame.origin), glm::dvec3(tree.frame.origin)};
    for (const ClusterNode& node : tree.nodes)
        if (node.level == tree.layout.levels)
            for (const glm::dvec3& corner : tree.cellOf(node)) box = {glm::min(box.low, corner), glm::max(box.high, corner)};
    return box;
}

vtkSmartPointer<vtkImageData> pixelImage(const Dump& dump) {
    const auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(int(dump.width()), int(dump.height()), 1);
    for (const auto& [name, unit] : {std::pair("sample_tests", "tests"), std::pair("visibility", "")}) {
        const auto values = dump.readPerPixel<uint32_t>(name);
        std::vector<uint32_t> upwards;  // VTK's rows go up
        for (uint32_t y = dump.height(); y-- > 0;)
            upwards.insert(upwards.end(), values.begin() + ptrdiff_t(y) * dump.width(), values.begin() + ptrdiff_t(y + 1) * dump.width());
        image->GetPointData()->AddArray(array(name, unit, std::span<const uint32_t>(upwards)));
    }
    image->GetPointData()->SetActiveScalars("sample_tests");
    addFact(*image, "title", dump.title());
    return image;
}

void writeHeatMap(const Options& options, const Dump& dump) {
    std::vector<uint8_t> isSample;
    for (const glm::uvec4& sample : dump.readPerPixel<glm::uvec4>("samples")) isSample.push_back(sample.w <= GNO_NO_CASTER);
    host::writePng(options.out / (dump.name() + "-clusters-tests.png"),
                   host::heatMap({dump.width(), dump.height(), dump.readPerPixel<uint32_t>("sample_tests")}, isSample,
                                 {dump.title() + ": tests of a sample", "tests", {}}));
}

/// What one level's panels show.
struct Level {
    std::vector<ClusterNode> nodes;  ///< the nearest ones
    size_t occupied = 0, accepted = 0;
    [[nodiscard]] std::string leftOut(uint32_t number) const {
        const std::string all = fmt::format("level {}: {} occupied nodes, {} of them accepted", number, grouped(occupied), grouped(accepted));
        if (nodes.size() == occupied) return all;
        return fmt::format("{}; drawing {} of {} boxes: those nearest to the viewer (--limit)", all, grouped(nodes.size()), grouped(occupied));
    }
};

Level levelOf(const Dump& dump, const ClusterTree& tree, uint32_t number, size_t limit) {
    Level level{{}, tree.occupied[number], tree.accepted[number]};
    std::vector<std::pair<float, size_t>> order;
    for (size_t i = 0; i < tree.nodes.size(); ++i)
        if (tree.nodes[i].level == number) order.emplace_back(distanceOf(dump, tree, tree.nodes[i]), i);
    std::sort(order.begin(), order.end());
    if (order.size() > limit) order.resize(limit);
    for (const auto& [distance, i] : order) level.nodes.push_back(tree.nodes[i]);
    return level;
}

std::vector<vtkSmartPointer<vtkActor>> addLevel(Picture& picture, const Dump& dump, const ClusterTree& tree, const Level& level,
                                                const std::string& color, vtkLookupTable& table) {
    std::vector<vtkSmartPointer<vtkActor>> actors;
    const std::string by = color == "distance" ? "distance" : "accepted";
    const MeshLook look{.opacity = 0.8, .edges = level.nodes.size() > 1000 ? 0.0 : 0.8};
    actors.push_back(addMesh(picture.panel(0), *nodeMesh(dump, tree, level.nodes, Shape::cell), look, by, &table));
    std::vector<ClusterNode> boxed;
    for (const ClusterNode& node : level.nodes)
        if (node.boxed) boxed.push_back(node);
    if (!boxed.empty()) actors.push_back(addMesh(picture.panel(1), *nodeMesh(dump, tree, boxed, Shape::box), look, by, &table));
    return actors;
}

vtkSmartPointer<vtkLookupTable> tableOf(const Dump& dump, const ClusterTree& tree, const std::string& color) {
    if (color != "distance") return kindColours(kNodeKinds);
    return numberColours(tree.slices.front() * dump.metres(), tree.slices.back() * dump.metres());
}

void prepare(Picture& picture, const Dump& dump, const ClusterTree& tree, std::span<const Corners> corners, const Options& options,
             vtkLookupTable& table, int panels) {
    const double size = glm::length(dump.high() - dump.low()) * dump.metres();
    for (int i = 0; i < panels; ++i) {
        addScene(picture.panel(i), dump, corners, 0.3);
        if (tree.frame.origin.w != 0) addBall(picture.panel(i), dump.world(glm::dvec3(tree.frame.origin)), 0.01 * size, kGreen);
        if (options.color == "distance")
            picture.legend(i, table, "distance from\nthe viewer [m]");
        else
            picture.legend(i, kNodeKinds);
    }
    picture.panelTitle(0, tree.layout.form == GNO_CLUSTER_FLAT ? "tiles with their depth range" : "implicit: the cell of the node's key");
    if (panels > 1) picture.panelTitle(1, "explicit: the box of the node's samples");
}

}  // namespace

void viewClusters(const Options& options) {
    if (options.dumps.size() > 1) throw host::InputError("clusters: one dump at a time");
    const Dump dump = Dump::load(options.dumps.front());
    const ClusterTree tree = ClusterTree::read(dump);
    if (tree.nodes.size() != dump.counter("occupied_nodes"))
        throw host::InputError(fmt::format("{}: {} nodes are occupied, and the record counted {}: a part of the dump is damaged, or of another run",
                                           dump.name(), tree.nodes.size(), dump.counter("occupied_nodes")));
    const std::vector<Corners> corners = cornersOf(dump);
    const auto table = tableOf(dump, tree, options.color);
    PictureSize size = options.size;
    size.columns = std::any_of(tree.nodes.begin(), tree.nodes.end(), [](const ClusterNode& node) { return node.boxed; }) ? 2 : 1;
    const std::string title = "view-sample clusters: " + dump.title(),
                      settings = "settings: " + dump.record().value("settings", nlohmann::json()).dump();

    if (options.interactive) {
        Picture picture(size, title, true);
        prepare(picture, dump, tree, corners, options, *table, size.columns);
        std::vector<vtkSmartPointer<vtkActor>> actors;
        const auto to = [&](int number) {
            for (int panel = 0; panel < size.columns; ++panel)
                for (const auto& actor : actors) picture.panel(panel).RemoveActor(actor);
            actors = addLevel(picture, dump, tree, levelOf(dump, tree, uint32_t(number), options.limit), options.color, *table);
        };
        to(1);
        picture.lookAt(dump, options.view, focusOf(tree));
        picture.show({"level of the hierarchy", 1, int(tree.layout.levels), 1, to}, options.closeAfter);
        return;
    }

    host::makeFolder(options.out);
    writeFile(options.out / (dump.name() + "-clusters-implicit.vtp"), *nodeMesh(dump, tree, tree.nodes, Shape::cell));
    std::vector<ClusterNode> boxed;
    std::copy_if(tree.nodes.begin(), tree.nodes.end(), std::back_inserter(boxed), [](const ClusterNode& node) { return node.boxed; });
    if (!boxed.empty()) writeFile(options.out / (dump.name() + "-clusters-explicit.vtp"), *nodeMesh(dump, tree, boxed, Shape::box));
    writeFile(options.out / (dump.name() + "-clusters-pixels.vti"), *pixelImage(dump));
    writeHeatMap(options, dump);
    for (uint32_t number = 1; number <= tree.layout.levels; ++number) {
        const Level level = levelOf(dump, tree, number, options.limit);
        Picture picture(size, title);
        prepare(picture, dump, tree, corners, options, *table, size.columns);
        (void)addLevel(picture, dump, tree, level, options.color, *table);
        picture.note(level.leftOut(number));
        picture.note("green ball: the viewer; yellow ball: the light");
        picture.note(settings);
        picture.lookAt(dump, options.view, focusOf(tree));
        picture.writePng(options.out / fmt::format("{}-clusters-level-{}.png", dump.name(), number));
        fmt::print("{}: {}\n", dump.title(), level.leftOut(number));
    }
}

}  // namespace gno::viz
