// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "validation/study/report/figures.hpp"
#include "viz/charts/palette.hpp"

namespace gno::report {

using viz::Line;
using viz::Marker;

Looks::Looks(const Study& study) : colors_(viz::colorsOf(study.techniques)) {
    for (const std::string& precision : study.precisions)
        if (rank(precision) == 0) others_.push_back(precision);
    std::sort(others_.begin(), others_.end());
}

viz::Look Looks::of(const std::string& technique, const std::string& precision, bool peer) const {
    viz::Look look{colors_.at(technique), Marker::diamond, Line::dashDotted, 2, peer};
    switch (rank(precision)) {
        case 3:
            look.marker = Marker::circle, look.line = Line::solid;
            break;
        case 2:
            look.marker = Marker::square, look.line = Line::dashed;
            break;
        case 1:
            look.marker = Marker::cross, look.line = Line::dotted;
            break;
        default: {  // a peer's own word
            constexpr std::array kMarkers{Marker::diamond, Marker::square, Marker::plus, Marker::circle};
            look.marker = kMarkers[size_t(std::find(others_.begin(), others_.end(), precision) - others_.begin()) % kMarkers.size()];
        }
    }
    return look;
}

std::vector<std::pair<std::string, viz::Look>> Looks::legend(const std::vector<std::string>& techniques,
                                                             const std::vector<std::string>& precisions) const {
    std::vector<std::pair<std::string, viz::Look>> entries{{"technique: colour", {}}};
    for (const std::string& technique : techniques)
        entries.emplace_back(technique, viz::Look{color(technique), Marker::none, Line::solid, 6, false});
    entries.emplace_back("", viz::Look{});
    entries.emplace_back("precision: marker, line", viz::Look{});
    for (const std::string& precision : precisions) {
        viz::Look look = of(techniques.front(), precision, rank(precision) == 0);
        look.color = viz::kInk;
        entries.emplace_back(precision, look);
    }
    return entries;
}

std::string provenance(const Study& study, const std::string& size) {
    return fmt::format("{}; {}; gnomon-study report {}", study.device, size, study.results.file.filename().string());
}

}  // namespace gno::report
