// SPDX-License-Identifier: MIT
#include "viz/tree_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "viz/picture.hpp"

namespace gno::viz {
namespace {

Color bytesOf(glm::dvec3 colour) {
    Color result;
    for (int i = 0; i < 3; ++i) result[size_t(i)] = uint8_t(std::lround(255 * colour[i]));
    return result;
}

Axis axis(const std::string& title, std::optional<double> low = {}, std::optional<double> high = {}) {
    Axis result;
    result.title = title;
    result.low = low;
    result.high = high;
    return result;
}

Series barsOf(const std::vector<uint64_t>& counts, glm::dvec3 colour, double start = 0, double width = 1) {
    Series series;
    series.look.color = bytesOf(colour);
    series.bars = true;
    series.barWidth = 0.85 * width;
    for (size_t i = 0; i < counts.size(); ++i) series.points.push_back({start + (double(i) + 0.5) * width, double(counts[i]), {}});
    return series;
}

/// Bars over whole numbers stand at the numbers themselves.
Series barsOfDepths(const std::vector<uint64_t>& counts, glm::dvec3 colour) { return barsOf(counts, colour, -0.5); }

constexpr std::array kMarkers{Marker::diamond, Marker::circle, Marker::circle, Marker::square, Marker::square, Marker::diamond, Marker::cross};

}  // namespace

Figure statisticsFigure(const Dump& dump, const TreeStatistics& statistics) {
    Figure figure;
    figure.title = "TOP tree: " + dump.title();
    figure.subtitle = fmt::format(
        "{} of {} casters in the tree; links: {} to a positive child, {} to a positive child of a cap, {} ({:.1f} %) to an intersection child",
        grouped(statistics.volumes), grouped(statistics.casters), grouped(statistics.lateralPositive), grouped(statistics.capPositive),
        grouped(statistics.intersection), 100 * statistics.intersectionShare());
    figure.columns = 2;
    figure.width = 1200;
    figure.height = 800;
    const double last = statistics.deepest + 0.5;
    figure.panels.push_back({fmt::format("where the volumes hang: depth {:.1f} on average", statistics.meanDepth),
                             axis("volumes above", -0.5, last),
                             axis("shadow volumes", 0.0),
                             {barsOfDepths(statistics.volumesAtDepth, kBlue)}});
    figure.panels.push_back({fmt::format("where the queries go: {:.1f} visited nodes a sample",
                                         double(statistics.visits) / double(std::max<uint64_t>(1, statistics.samples))),
                             axis("volumes above", -0.5, last),
                             axis("visited nodes in the frame", 0.0),
                             {barsOfDepths(statistics.visitsAtDepth, kVermilion)}});
    const std::vector<double>& edges = statistics.wedges.edges;
    figure.panels.push_back(
        {fmt::format("how wide intersection children reach ({} of them without a bound)", grouped(statistics.wedgesWithoutBound)),
         axis(fmt::format("both sides of the plane together [{}]", statistics.wedges.unit), -0.5, double(edges.size()) - 1.5),
         axis("intersection children", 0.0),
         {barsOfDepths(statistics.wedges.counts, kGreen)}});
    for (size_t i = edges.size() - 1; i-- > 0;)
        if ((edges.size() - 2 - i) % 3 == 0) figure.panels.back().x.names.emplace_back(double(i), i == 0 ? "0" : fmt::format("{:.3g}+", edges[i]));
    Panel visits{"how often a node is visited",
                 axis("visits in the frame", -0.5, double(statistics.visitsOfNodes.counts.size()) - 0.5),
                 axis("nodes", 0.0),
                 {barsOfDepths(statistics.visitsOfNodes.counts, kPurple)}};
    const size_t bins = statistics.visitsOfNodes.counts.size(), every = std::max<size_t>(1, bins / 8);
    for (size_t i = 0; i < bins; ++i) {  // edges 0, 1, 2, 4, ...
        const double from = statistics.visitsOfNodes.edges[i];
        if (i == 0 || i % every == 0) visits.x.names.emplace_back(double(i), i == 0 ? "0" : fmt::format("{}+", grouped(uint64_t(from))));
    }
    figure.panels.push_back(visits);
    return figure;
}

Figure stepsFigure(const std::string& title, std::span<const QueryPath> paths) {
    Figure figure;
    figure.title = title;
    figure.subtitle = "each visited node by its depth in the tree, in the order of the visits";
    figure.columns = paths.size() > 1 ? 2 : 1;
    figure.width = 1300;
    figure.height = paths.size() > 2 ? 800 : 460;
    uint32_t deepest = 1;
    size_t longest = 1;
    for (const QueryPath& path : paths) {
        longest = std::max(longest, path.visits.size());
        for (const Visit& visit : path.visits) deepest = std::max(deepest, visit.depth);
    }
    const auto lookOf = [](size_t kind) { return Look{.color = bytesOf(stepKinds()[kind].colour), .marker = kMarkers[kind]}; };
    std::vector<bool> shown(stepKinds().size());
    for (const QueryPath& path : paths) {
        Panel panel{fmt::format("{}: {} visited nodes, {} from the stack, {} back by ancestor link", path.technique, path.visits.size(),
                                path.count(Step::pop), path.count(Step::ancestor)),
                    axis("visit", 0.0, double(longest)),
                    axis("depth in the tree [nodes above]", -0.5, deepest + 1.0),
                    {}};
        Series way;
        way.look = {.color = bytesOf(kPale), .line = Line::solid, .width = 1};
        std::vector<Series> marks(stepKinds().size());
        for (size_t i = 0; i < path.visits.size(); ++i) {
            way.points.push_back({double(i), double(path.visits[i].depth), {}});
            marks[size_t(path.visits[i].step)].points.push_back(way.points.back());
        }
        panel.series.push_back(way);
        for (size_t kind = 0; kind < marks.size(); ++kind) {
            if (marks[kind].points.empty()) continue;
            marks[kind].look = lookOf(kind);
            shown[kind] = true;
            panel.series.push_back(marks[kind]);
        }
        figure.panels.push_back(std::move(panel));
    }
    figure.legend.push_back({"how it came there", Look{}});
    for (size_t kind = 0; kind < shown.size(); ++kind)
        if (shown[kind]) figure.legend.push_back({stepKinds()[kind].name, lookOf(kind)});
    return figure;
}

}  // namespace gno::viz
