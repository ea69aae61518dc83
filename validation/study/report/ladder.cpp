// SPDX-License-Identifier: MIT
// What each rung of the precision ladder costs and mends: bars of time as a ratio to the lowest rung of the same technique and settings, wrong
// samples.
#include <fmt/format.h>

#include <algorithm>

#include "validation/study/report/figures.hpp"
#include "viz/charts/palette.hpp"

namespace gno::report {
namespace {

struct Rung {
    Spread time;  ///< as a ratio to the lowest rung
    double wrong = 0;
};
using Ladder = std::map<std::string, Rung>;  ///< by precision

/// Of each technique at default settings that has at least two rungs here.
std::map<std::string, Ladder> laddersOf(const Setup& setup) {
    std::map<std::string, std::vector<const Variant*>> rungs;
    for (const Variant& variant : setup.variants)
        if (variant.isChecked() && variant.varied.empty() && variant.bestOf.empty() && rank(variant.precision) > 0)
            rungs[variant.technique].push_back(&variant);
    std::map<std::string, Ladder> ladders;
    for (auto& [technique, variants] : rungs) {
        if (variants.size() < 2) continue;
        const Variant* lowest =
            *std::min_element(variants.begin(), variants.end(), [](auto* a, auto* b) { return rank(a->precision) < rank(b->precision); });
        for (const Variant* variant : variants) ladders[technique][variant->precision] = {timeRatio(*variant, *lowest), variant->wrongPerMillion()};
    }
    return ladders;
}

viz::Color tint(viz::Color color, const std::string& precision) {
    const double share = rank(precision) == 3 ? 0 : rank(precision) == 2 ? 0.4 : 0.7;
    for (uint8_t& channel : color) channel = uint8_t(channel + share * (255 - channel));
    return color;
}

viz::Figure draw(const Study& study, const Looks& looks, const std::map<std::string, Ladder>& ladders) {
    constexpr double kOffset = 0.27;
    viz::Figure figure;
    figure.width = 1100;
    figure.height = 700;
    viz::Panel time, wrong;
    time.title = "time as a ratio to the lowest rung of the same technique";
    time.y = {"time / lowest rung", false, {}, 0.0, {}, {}};
    wrong.title = "wrong samples per million";
    wrong.y = {"wrong per million", true, "0 = exact", {}, {}, {}};
    std::vector<std::string> techniques;
    for (const std::string& name : study.techniques)
        if (ladders.contains(name)) techniques.push_back(name);
    for (size_t i = 0; i < techniques.size(); ++i) {
        time.x.names.emplace_back(double(i), techniques[i]);
        for (const auto& [precision, rung] : ladders.at(techniques[i])) {
            const double x = double(i) + kOffset * (rank(precision) - 2);
            viz::Series bar{{tint(looks.color(techniques[i]), precision), viz::Marker::none, viz::Line::none, 1, false},
                            {{x, {rung.time.median, rung.time.low, rung.time.high}, {}}},
                            {}};
            bar.bars = true;
            bar.barWidth = 0.25;
            time.series.push_back(std::move(bar));
            wrong.series.push_back({looks.of(techniques[i], precision, false), {{x, rung.wrong, {}}}, {}});
        }
    }
    time.x.low = -0.5, time.x.high = double(techniques.size()) - 0.5;
    wrong.x = time.x;
    figure.panels = {std::move(time), std::move(wrong)};
    figure.legend.emplace_back("precision: shade", viz::Look{});
    for (const char* precision : {"published", "conservative", "certified"})
        figure.legend.emplace_back(fmt::format("{} ", precision),
                                   viz::Look{tint(viz::kInk, precision), viz::Marker::square, viz::Line::none, 1, false});
    figure.legend.emplace_back("", viz::Look{});
    figure.legend.emplace_back("precision: marker", viz::Look{});
    for (const char* precision : {"published", "conservative", "certified"}) {
        viz::Look look = looks.of(techniques.front(), precision, false);
        look.color = viz::kInk;
        look.line = viz::Line::none;
        figure.legend.emplace_back(precision, look);
    }
    return figure;
}

}  // namespace

std::vector<NamedFigure> ladderFigures(const Study& study, const Looks& looks) {
    std::vector<NamedFigure> figures;
    std::map<std::string, std::map<std::string, std::vector<Rung>>> all;  // technique, precision, setups
    for (const Setup& setup : study.setups) {
        const auto ladders = laddersOf(setup);
        if (ladders.empty()) continue;
        for (const auto& [technique, ladder] : ladders)
            for (const auto& [precision, rung] : ladder) all[technique][precision].push_back(rung);
        viz::Figure figure = draw(study, looks, ladders);
        figure.title = fmt::format("The precision ladder: {}", setup.title);
        figure.subtitle = provenance(study, fmt::format("{}x{}", setup.size[0], setup.size[1]));
        figures.push_back({"ladder-" + setup.slug, "ladder",
                           "Default settings. Whiskers: spread of the repeats, each compared with its neighbour in time.", std::move(figure)});
    }
    if (figures.empty()) return figures;
    std::map<std::string, Ladder> overall;
    for (const auto& [technique, precisions] : all)
        for (const auto& [precision, rungs] : precisions) {
            std::vector<double> times;
            double worst = 0;
            for (const Rung& rung : rungs) {
                times.push_back(rung.time.median);
                worst = std::max(worst, rung.wrong);
            }
            overall[technique][precision] = {
                {geometricMean(times), *std::min_element(times.begin(), times.end()), *std::max_element(times.begin(), times.end())}, worst};
        }
    viz::Figure figure = draw(study, looks, overall);
    figure.title = fmt::format("The precision ladder over {} scenes and lights", figures.size());
    figure.subtitle = provenance(study, study.sizes());
    figure.panels[1].title = "wrong samples per million, worst scene and light";
    figures.insert(
        figures.begin(),
        {"ladder", "ladder",
         "Default settings; geometric mean over scenes and lights, whiskers from the lightest to the heaviest; below, the worst error of any.",
         std::move(figure)});
    return figures;
}

}  // namespace gno::report
