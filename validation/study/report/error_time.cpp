// SPDX-License-Identifier: MIT
// Error against time: one chart a setup, and one over all of them.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "validation/study/report/figures.hpp"
#include "viz/charts/palette.hpp"

namespace gno::report {
namespace {

/// What a point of these charts is; over several setups `time` spans them and `error` is the worst.
struct Dot {
    const Variant* variant;
    Spread time;
    double error;
    std::string note = {};  ///< behind the label
    float lift = 0;         ///< lane in the row of the exact ones
    bool isBest = false;    ///< of the exact ones of its technique
};

constexpr double kLane = 16, kPlotHeight = 540;  // pixels of the page
constexpr size_t kMostLanes = 14;                // as many as there are colours

/// In the row of the exact ones each technique has a lane of its own, the fastest on top. Returns the share of the decades that the row needs.
double spreadLanes(std::vector<Dot>& dots) {
    std::map<std::string, double> fastest;
    for (const Dot& dot : dots)
        if (dot.error == 0) {
            double& time = fastest.try_emplace(dot.variant->technique, dot.time.median).first->second;
            time = std::min(time, dot.time.median);
        }
    std::vector<std::string> order;
    for (const auto& [technique, time] : fastest) order.push_back(technique);
    std::sort(order.begin(), order.end(), [&](const std::string& x, const std::string& y) { return fastest[x] < fastest[y]; });
    const size_t lanes = std::clamp<size_t>(order.size(), 1, kMostLanes);
    for (Dot& dot : dots) {
        if (dot.error != 0) continue;
        const size_t lane = size_t(std::find(order.begin(), order.end(), dot.variant->technique) - order.begin()) % lanes;
        dot.lift = float(kLane * (double(lanes - 1) / 2 - double(lane)));
        dot.isBest = dot.time.median == fastest[dot.variant->technique];
    }
    const double band = (kLane * double(lanes) + 20) / kPlotHeight;  // 1.2 of 1 + 1.6 shares, as viz/charts/scale.cpp has it
    return band / (1.2 - 1.6 * band);
}

/// The settings other than `name`, as text: dots of one technique and precision that agree in it lie on one curve.
std::string without(const nlohmann::ordered_json& varied, const std::string& name) {
    auto rest = varied;
    rest.erase(name);
    return rest.dump();
}

/// One series a technique and precision and numeric setting that moves; what is on no curve stands alone.
std::vector<viz::Series> seriesOf(const std::vector<Dot>& dots, const Looks& looks) {
    std::vector<viz::Series> curves;
    std::set<const Dot*> onCurve;
    std::map<std::string, std::map<double, const Dot*>> candidates;
    for (const Dot& dot : dots)
        for (const auto& [name, value] : dot.variant->varied.items()) {
            if (!value.is_number()) continue;
            const std::string curve = fmt::format("{}|{}|{}|{}|{}", dot.variant->technique, dot.variant->precision, dot.variant->bestOf, name,
                                                  without(dot.variant->varied, name));
            candidates[curve][value.get<double>()] = &dot;
            for (const Dot& other : dots) {  // the same settings with this one at its default
                const auto& settings = other.variant->rows.front()->settings;
                if (other.variant->technique == dot.variant->technique && other.variant->precision == dot.variant->precision &&
                    other.variant->bestOf == dot.variant->bestOf && !other.variant->varied.contains(name) &&
                    other.variant->varied.dump() == without(dot.variant->varied, name) && settings.contains(name) && settings.at(name).is_number())
                    candidates[curve][settings.at(name).get<double>()] = &other;
            }
        }
    const auto point = [](const Dot& dot) { return viz::Point{{dot.time.median, dot.time.low, dot.time.high}, dot.error, {}, dot.lift}; };
    for (const auto& [name, byValue] : candidates) {
        if (byValue.size() < 2) continue;
        const Variant& first = *byValue.begin()->second->variant;
        viz::Series curve{looks.of(first.technique, first.precision, first.peer), {}, {}};
        for (const auto& [value, dot] : byValue) {
            curve.points.push_back(point(*dot));
            onCurve.insert(dot);
        }
        curves.push_back(std::move(curve));
    }
    for (const Dot& dot : dots)
        if (!onCurve.contains(&dot))
            curves.push_back({looks.of(dot.variant->technique, dot.variant->precision, dot.variant->peer), {point(dot)}, {}});
    return curves;
}

/// The front of what runs on the device, as steps; its corners, what is exact and the peers carry labels.
void addFront(viz::Panel& panel, const std::vector<Dot>& dots) {
    std::vector<Cost> costs;
    std::vector<const Dot*> own;
    viz::Series labels{{viz::kInk, viz::Marker::none, viz::Line::none, 1, false}, {}, {}};
    for (const Dot& dot : dots) {
        if (dot.variant->peer) continue;
        costs.push_back({dot.time.median, dot.error});
        own.push_back(&dot);
    }
    viz::Series front{{{190, 190, 190}, viz::Marker::none, viz::Line::solid, 5, false}, {}, "Pareto front"};
    front.steps = true;
    std::set<const Dot*> isLabelled;
    for (const size_t i : paretoFront(costs)) {
        front.points.push_back({costs[i].time, costs[i].error, {}, own[i]->lift});
        isLabelled.insert(own[i]);
    }
    for (const Dot& dot : dots)
        if ((dot.variant->peer && dot.error > 0) || dot.isBest || isLabelled.contains(&dot)) {
            const std::string text = dot.error == 0 && dot.variant->precision == "certified"
                                         ? dot.variant->label()
                                         : fmt::format("{} ({})", dot.variant->label(), dot.variant->precision);
            labels.points.push_back({dot.time.median, dot.error, text + dot.note, dot.lift});
        }
    panel.series.insert(panel.series.begin(), std::move(front));
    panel.series.push_back(std::move(labels));
}

viz::Figure errorTime(const Study& study, const Looks& looks, const std::vector<Dot>& dots, double zeroShare, const std::string& errorTitle) {
    viz::Figure figure;
    figure.width = 1100;
    figure.height = 680;
    viz::Panel panel;
    panel.x = {"time as a ratio to a bare full-screen pass (median; whiskers: spread)", true, {}, {}, {}, {}};
    panel.y = {errorTitle, true, "0 = exact", {}, {}, {}, zeroShare};
    panel.series = seriesOf(dots, looks);
    addFront(panel, dots);
    figure.panels.push_back(std::move(panel));
    std::vector<std::string> techniques, precisions;
    for (const std::string& name : study.techniques)
        if (std::any_of(dots.begin(), dots.end(), [&](const Dot& dot) { return dot.variant->technique == name; })) techniques.push_back(name);
    for (const std::string& name : study.precisions)
        if (std::any_of(dots.begin(), dots.end(), [&](const Dot& dot) { return dot.variant->precision == name; })) precisions.push_back(name);
    figure.legend = looks.legend(techniques, precisions);
    figure.legend.emplace_back("", viz::Look{});
    return figure;
}

std::vector<std::string> missingFrom(const Setup& setup) {
    std::vector<std::string> missing;
    for (const Variant& variant : setup.variants)
        if (!variant.isMeasured()) missing.push_back(fmt::format("{}: unavailable, {}", variant.fullName(), variant.unavailable));
    return missing;
}

}  // namespace

std::vector<NamedFigure> errorTimeFigures(const Study& study, const Looks& looks) {
    std::vector<NamedFigure> figures;
    for (const Setup& setup : study.setups) {
        std::vector<Dot> dots;
        for (const Variant& variant : setup.variants)
            if (variant.isChecked()) dots.push_back({&variant, variant.time, variant.wrongPerMillion()});
        if (dots.empty()) continue;
        const double zeroShare = spreadLanes(dots);
        viz::Figure figure = errorTime(study, looks, dots, zeroShare, "wrong samples per million");
        figure.title = fmt::format("Error against time: {}", setup.title);
        figure.subtitle = provenance(study, fmt::format("{}x{}", setup.size[0], setup.size[1]));
        std::string caption =
            fmt::format("{} casters, {} frame{}. Left is faster, lower is more right; a curve joins the values of one setting.", setup.casters,
                        setup.frames.size(), setup.frames.size() == 1 ? "" : "s, geometric mean of times and all samples together");
        for (const std::string& line : missingFrom(setup)) caption += fmt::format(" Not in the chart: {}.", line);
        figures.push_back({"error_time-" + setup.slug, "error_time", std::move(caption), std::move(figure)});
    }
    return figures;
}

NamedFigure overviewFigure(const Study& study, const Looks& looks) {
    // A mean over other scenes is no comparison: only setups with most of the variants take part (a family measured for its growth has few).
    const auto checkedIn = [](const Setup& setup) {
        return size_t(std::count_if(setup.variants.begin(), setup.variants.end(), [](const Variant& v) { return v.isChecked(); }));
    };
    size_t most = 0, setups = 0;
    for (const Setup& setup : study.setups) most = std::max(most, checkedIn(setup));
    std::map<std::string, std::vector<const Variant*>> byKey;
    for (const Setup& setup : study.setups) {
        if (2 * checkedIn(setup) <= most) continue;
        ++setups;
        for (const Variant& variant : setup.variants)
            if (variant.isChecked()) byKey[variant.key()].push_back(&variant);
    }
    std::vector<Dot> dots;
    for (const auto& [key, variants] : byKey) {
        if (2 * variants.size() < setups) continue;  // a setting tried on few scenes says nothing about all
        std::array<std::vector<double>, 3> times;
        double worst = 0;
        for (const Variant* variant : variants) {
            times[0].push_back(variant->time.median);
            times[1].push_back(variant->time.low);
            times[2].push_back(variant->time.high);
            worst = std::max(worst, variant->wrongPerMillion());
        }
        dots.push_back({variants.front(),
                        {geometricMean(times[0]), geometricMean(times[1]), geometricMean(times[2])},
                        worst,
                        variants.size() < setups ? fmt::format(" ({} of {} scenes)", variants.size(), setups) : ""});
    }
    const double zeroShare = spreadLanes(dots);
    viz::Figure figure = errorTime(study, looks, dots, zeroShare, "wrong samples per million, worst scene and light");
    figure.panels[0].x.title = "time as a ratio to a bare full-screen pass (geometric mean over scenes; whiskers: spread of the repeats)";
    figure.title = fmt::format("What accuracy costs: {} scene{}, error against time", setups, setups == 1 ? "" : "s and lights");
    figure.subtitle = provenance(study, study.sizes());
    return {"overview", "overview",
            "Every technique and setting that was measured on at least half of the scenes and lights. Left is faster, lower is more right; the "
            "lowest row is exact.",
            std::move(figure)};
}

}  // namespace gno::report
