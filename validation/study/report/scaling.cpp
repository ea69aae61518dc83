// SPDX-License-Identifier: MIT
// How time and counters grow: with the casters of a family of generated scenes (NAME_1000, NAME_4000, ...) and with the resolution of one scene.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_min/output/record.hpp"
#include "validation/study/report/figures.hpp"

namespace gno::report {
namespace {

struct Quantity {
    std::string name, title;
    Spread (*of)(const Row&);
};

Spread exactly(double value) { return {value, value, value}; }
Spread perSample(uint64_t count, const Row& row) { return exactly(row.samples > 0 ? double(count) / double(row.samples) : 0); }

const std::vector<Quantity>& quantities() {
    static const std::vector<Quantity> all{
        {"time", "time, ms (median; whiskers: spread)", [](const Row& row) { return spreadOf(row.totalMs); }},
        {"nodes", "visited nodes per sample", [](const Row& row) { return perSample(row.counter("visited_nodes"), row); }},
        {"tests", "test-and-set operations", [](const Row& row) { return exactly(double(row.counter("test_and_set"))); }},
    };
    return all;
}

/// "fuzzy_16000" -> "fuzzy"; empty: no number at the end.
std::string familyOf(const std::string& name) {
    const size_t end = name.find_last_not_of("0123456789");
    if (end == std::string::npos || end + 1 == name.size()) return {};
    return name.substr(0, name[end] == '_' || name[end] == '-' ? end : end + 1);
}

using Curve = std::map<double, const Row*>;  ///< rows by what grows

/// One series a technique at the highest rung it has here, default settings; the legend tells the exponent.
viz::Figure draw(const std::map<std::string, Curve>& curves, const Quantity& quantity, const std::string& grows, const Looks& looks) {
    viz::Figure figure;
    figure.width = 1100;
    figure.height = 600;
    viz::Panel panel;
    panel.x = {grows, true, {}, {}, {}, {}};
    panel.y = {quantity.title, true, {}, {}, {}, {}};
    for (const auto& [key, curve] : curves) {
        std::vector<double> x, y;
        viz::Series series;
        for (const auto& [at, row] : curve) {
            const Spread value = quantity.of(*row);
            if (!(value.median > 0)) continue;
            x.push_back(at);
            y.push_back(value.median);
            viz::Value whiskers = value.median;
            if (value.high > value.low) whiskers = {value.median, value.low, value.high};
            series.points.push_back({at, whiskers, {}});
        }
        const auto fit = fitPower(x, y);
        if (!fit) continue;
        const Row& row = *curve.begin()->second;
        series.look = looks.of(row.technique, row.precision, row.peer);
        series.legend = fmt::format("{} {}: n^{:.2f}{}", row.technique, row.precision, fit->exponent,
                                    fit->standardError ? fmt::format(" ± {:.2f}", *fit->standardError) : "");
        panel.series.push_back(std::move(series));
    }
    figure.panels.push_back(std::move(panel));
    return figure;
}

/// The technique's curve at the highest rung that has at least two values.
std::map<std::string, Curve> highestRungs(const std::vector<std::pair<double, const Row*>>& rows) {
    std::map<std::string, std::map<std::string, Curve>> all;
    for (const auto& [at, row] : rows)
        if (row->isMeasured() && row->varied.empty() && row->bestOf.empty()) all[row->technique][row->precision].try_emplace(at, row);
    std::map<std::string, Curve> highest;
    for (auto& [technique, precisions] : all) {
        const Curve* best = nullptr;
        int bestRank = -1;
        for (const auto& [precision, curve] : precisions) {
            if (curve.size() < 2 || rank(precision) <= bestRank) continue;
            best = &curve, bestRank = rank(precision);
        }
        if (best != nullptr) highest[technique] = *best;
    }
    return highest;
}

void addFigures(std::vector<NamedFigure>& figures, const std::vector<std::pair<double, const Row*>>& rows, const std::string& grows,
                const std::string& what, const std::string& slug, const Study& study, const std::string& size, const Looks& looks) {
    const auto curves = highestRungs(rows);
    for (const Quantity& quantity : quantities()) {
        viz::Figure figure = draw(curves, quantity, grows, looks);
        if (figure.panels[0].series.empty()) continue;
        figure.title = what;
        figure.subtitle = provenance(study, size);
        figures.push_back(
            {fmt::format("growth-{}-{}", slug, quantity.name), "growth",
             "Default settings, the highest rung of each technique. Exponent by least squares on the logarithms, with its standard error.",
             std::move(figure)});
    }
}

}  // namespace

std::vector<NamedFigure> scalingFigures(const Study& study, const Looks& looks) {
    std::vector<NamedFigure> figures;
    std::map<std::string, std::vector<std::pair<double, const Row*>>> families;
    for (const Setup& setup : study.setups) {
        const std::string family = familyOf(setup.scene);
        if (family.empty() || setup.frames.empty()) continue;
        for (const Row* row : setup.rows)
            if (row->frame == setup.frames.front())
                families[fmt::format("{}|{}|{}|{}x{}", family, row->light, row->cull, setup.size[0], setup.size[1])].emplace_back(
                    double(row->casters), row);
    }
    for (const auto& [key, rows] : families) {
        const Row& first = *rows.front().second;
        const std::string family = familyOf(first.name);
        addFigures(figures, rows, "casters n (triangles)",
                   fmt::format("Growth with the number of casters: {}, light {} ({})", family, first.light, first.lightKind),
                   fmt::format("casters-{}-light{}-{}-{}x{}", family, first.light, first.cull, first.size[0], first.size[1]), study,
                   fmt::format("{}x{}", first.size[0], first.size[1]), looks);
    }
    for (const Setup& setup : study.setups) {
        std::vector<std::pair<double, const Row*>> rows;
        std::string sizes = fmt::format("{}x{}", setup.size[0], setup.size[1]);
        const auto add = [&](const Setup& sized) {
            for (const Row* row : sized.rows)
                if (!setup.frames.empty() && row->frame == setup.frames.front()) rows.emplace_back(double(row->size[0]) * row->size[1], row);
        };
        add(setup);
        for (const Setup& other : study.others)
            if (other.slug == setup.slug) {
                add(other);
                sizes += fmt::format(", {}x{}", other.size[0], other.size[1]);
            }
        if (sizes.find(',') == std::string::npos) continue;
        addFigures(figures, rows, "pixels n", fmt::format("Growth with the resolution: {}", setup.title), "pixels-" + setup.slug, study, sizes,
                   looks);
    }
    return figures;
}

}  // namespace gno::report
