// SPDX-License-Identifier: MIT
// How far wrong samples lie from the nearest silhouette of the exact mask: cumulative, one curve a technique and precision.
#include <fmt/format.h>

#include <algorithm>

#include "validation/study/report/figures.hpp"

namespace gno::report {
namespace {

/// Share of the wrong samples closer than each distance: (pixels, per cent), ascending.
std::vector<viz::Point> cumulative(const Variant& variant) {
    std::map<double, uint64_t> closer;  // by the upper end of a bin
    uint64_t all = 0;
    for (const Row* row : variant.rows) {
        if (!row->check) continue;
        const CheckedSamples& check = *row->check;
        for (size_t bin = 0; bin < check.distanceFrom.size(); ++bin) {
            const double from = check.distanceFrom[bin];  // bins double in width, the first goes to 1
            const double end = bin + 1 < check.distanceFrom.size() ? check.distanceFrom[bin + 1] : std::max({check.distanceMax, 2 * from, 1.0});
            closer[end] += check.distanceCounts[bin];
            all += check.distanceCounts[bin];
        }
    }
    std::vector<viz::Point> points;
    uint64_t sum = 0;
    for (const auto& [end, count] : closer) {
        if (sum == all) break;
        sum += count;
        points.push_back({end, 100 * double(sum) / double(all), {}});
    }
    return points;
}

}  // namespace

std::vector<NamedFigure> distanceFigures(const Study& study, const Looks& looks) {
    std::vector<NamedFigure> figures;
    for (const Setup& setup : study.setups) {
        viz::Panel panel;
        panel.x = {"closer to a silhouette than ... pixels", true, {}, 0.9, 16.0, {}};
        panel.y = {"share of the wrong samples, %", false, {}, 0.0, 100.0, {}};
        for (const Variant& variant : setup.variants) {
            if (!variant.isChecked() || variant.wrong == 0 || !variant.varied.empty()) continue;
            viz::Series series{looks.of(variant.technique, variant.precision, variant.peer), cumulative(variant),
                               fmt::format("{}: {}", variant.fullName(), variant.wrong)};
            if (series.points.empty()) continue;
            panel.x.high = std::max(*panel.x.high, 1.1 * series.points.back().x.at);
            panel.series.push_back(std::move(series));
        }
        if (panel.series.empty()) continue;
        viz::Figure figure;
        figure.width = 1100;
        figure.height = 520;
        figure.title = fmt::format("Wrong samples by distance to the nearest silhouette: {}", setup.title);
        figure.subtitle = provenance(study, fmt::format("{}x{}", setup.size[0], setup.size[1]));
        figure.panels.push_back(std::move(panel));
        figures.push_back({"distance-" + setup.slug, "distance",
                           "Default settings; techniques without a wrong sample have no curve. The legend holds the number of wrong samples.",
                           std::move(figure)});
    }
    return figures;
}

}  // namespace gno::report
