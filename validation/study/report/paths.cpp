// SPDX-License-Identifier: MIT
// Along a path: query time and work per frame of every technique (figure 7 of the 2016 paper, figures 5 and 6 of the 2014 one), stages of a
// technique with several passes (figures 5 and 9 of 2014).
#include <fmt/format.h>

#include <algorithm>

#include "validation/study/report/figures.hpp"
#include "viz/charts/palette.hpp"

namespace gno::report {
namespace {

constexpr size_t kLeastFrames = 3, kLeastPasses = 3;

using Curve = std::map<uint32_t, const Row*>;  ///< by frame

/// Each technique at the highest rung that it has along this path, default settings.
std::map<std::string, Curve> curvesOf(const Setup& setup) {
    std::map<std::string, std::map<int, Curve>> all;
    for (const Row* row : setup.rows)
        if (row->isMeasured() && row->varied.empty() && row->bestOf.empty()) all[row->technique][rank(row->precision)].try_emplace(row->frame, row);
    std::map<std::string, Curve> curves;
    for (const auto& [technique, rungs] : all)
        for (const auto& [rung, curve] : rungs)
            if (curve.size() >= kLeastFrames) curves[technique] = curve;
    return curves;
}

std::string meanAndDeviation(const std::vector<double>& values) {
    const double middle = mean(values), off = deviation(values);
    return middle < 100 ? fmt::format("{:.3g} ± {:.2g}", middle, off) : fmt::format("{:.0f} ± {:.0f}", middle, off);
}

/// Mean and standard deviation over the frames stand in the legend.
template <class Of>
viz::Panel panelOf(const std::map<std::string, Curve>& curves, const Looks& looks, const std::string& title, const std::string& unit, Of of) {
    viz::Panel panel;
    panel.title = title;
    panel.x.title = "frame";
    panel.y = {unit, false, {}, 0.0, {}, {}};
    for (const auto& [technique, curve] : curves) {
        viz::Series series;
        std::vector<double> values;
        for (const auto& [frame, row] : curve) {
            const Spread value = of(*row);
            values.push_back(value.median);
            series.points.push_back({double(frame), {value.median, value.low, value.high}, {}});
        }
        if (*std::max_element(values.begin(), values.end()) <= 0) continue;
        const Row& first = *curve.begin()->second;
        series.look = looks.of(technique, first.precision, first.peer);
        series.look.marker = viz::Marker::none;
        series.band = true;
        series.legend = fmt::format("{} {}: {}", technique, first.precision, meanAndDeviation(values));
        panel.series.push_back(std::move(series));
    }
    return panel;
}

viz::Figure single(const Study& study, const Setup& setup, viz::Panel panel, const std::string& title) {
    viz::Figure figure;
    figure.width = 1100;
    figure.height = 480;
    figure.title = fmt::format("{}: {}", title, setup.title);
    figure.subtitle = provenance(study, fmt::format("{}x{}", setup.size[0], setup.size[1]));
    figure.panels.push_back(std::move(panel));
    return figure;
}

/// Time of every pass of one technique along the path, as a ratio to the bare pass.
viz::Panel stagesOf(const Curve& curve) {
    std::vector<std::string> names;
    for (const auto& [frame, row] : curve)
        for (const TimedPass& pass : row->passes)
            if (std::find(names.begin(), names.end(), pass.name) == names.end()) names.push_back(pass.name);
    const auto colors = viz::colorsOf(names);
    constexpr std::array kLines{viz::Line::solid, viz::Line::dashed, viz::Line::dotted, viz::Line::dashDotted};
    viz::Panel panel;
    panel.x.title = "frame";
    panel.y = {"time / bare pass", false, {}, 0.0, {}, {}};
    for (size_t i = 0; i < names.size(); ++i) {
        viz::Series series{{colors.at(names[i]), viz::Marker::none, kLines[i % kLines.size()], 2, false}, {}, {}};
        std::vector<double> values;
        for (const auto& [frame, row] : curve)
            for (const TimedPass& pass : row->passes) {
                if (pass.name != names[i]) continue;
                const Spread value = spreadOf(row->toFloor(pass.ms));
                values.push_back(value.median);
                series.points.push_back({double(frame), {value.median, value.low, value.high}, {}});
            }
        series.band = true;
        series.legend = fmt::format("{}: {}", names[i], meanAndDeviation(values));
        panel.series.push_back(std::move(series));
    }
    return panel;
}

}  // namespace

std::vector<NamedFigure> pathFigures(const Study& study, const Looks& looks) {
    std::vector<NamedFigure> figures;
    std::vector<const Setup*> all;  // a path may be measured at a size of its own
    for (const auto* setups : {&study.setups, &study.others})
        for (const Setup& setup : *setups) all.push_back(&setup);
    for (const Setup* measured : all) {
        const Setup& setup = *measured;
        const auto curves = curvesOf(setup);
        if (curves.empty()) continue;
        const auto add = [&](const std::string& file, const std::string& caption, viz::Figure figure) {
            if (!figure.panels[0].series.empty())
                figures.push_back(
                    {fmt::format("path-{}-{}x{}-{}", setup.slug, setup.size[0], setup.size[1], file), "paths", caption, std::move(figure)});
        };
        const std::string legend = " The legend holds mean and standard deviation over the frames; the band is the spread of the repeats.";
        add("total", "Build and query of each technique at its highest rung." + legend,
            single(study, setup, panelOf(curves, looks, {}, "time / bare pass", [](const Row& row) { return spreadOf(row.toFloor(row.totalMs)); }),
                   "Time per frame"));
        add("query", "The query alone, without what is built for each frame." + legend,
            single(study, setup, panelOf(curves, looks, {}, "time / bare pass", [](const Row& row) { return spreadOf(row.toFloor(row.queryMs())); }),
                   "Query time per frame"));
        add("nodes", "Nodes that the queries of a frame visit, per sample." + legend,
            single(study, setup,
                   panelOf(curves, looks, {}, "nodes per sample",
                           [](const Row& row) {
                               const double nodes = double(row.counter("visited_nodes")) / double(std::max<uint64_t>(row.samples, 1));
                               return Spread{nodes, nodes, nodes};
                           }),
                   "Visited nodes per frame"));
        add("tests", "Test-and-set operations of a frame: one node or sample against one shadow volume." + legend,
            single(study, setup,
                   panelOf(curves, looks, {}, "operations, million",
                           [](const Row& row) {
                               const double tests = double(row.counter("test_and_set")) / 1e6;
                               return Spread{tests, tests, tests};
                           }),
                   "Test-and-set operations per frame"));
        for (const auto& [technique, curve] : curves)
            if (std::any_of(curve.begin(), curve.end(), [](const auto& entry) { return entry.second->passes.size() >= kLeastPasses; }))
                add("stages-" + technique, "Stages of one technique." + legend,
                    single(study, setup, stagesOf(curve), fmt::format("Stages of {}", technique)));
    }
    return figures;
}

}  // namespace gno::report
