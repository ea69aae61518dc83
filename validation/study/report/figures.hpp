// SPDX-License-Identifier: MIT
// The charts of the report. One colour a technique in all of them; marker and line tell the precision; hollow markers are peers.
#pragma once
#include <string>
#include <vector>

#include "validation/study/report/study.hpp"
#include "viz/charts/figure.hpp"

namespace gno::report {

struct NamedFigure {
    std::string file;     ///< without ".png"
    std::string section;  ///< of the page
    std::string caption;  ///< what to see and how to read it
    viz::Figure figure;
};

/// Looks of everything that can stand in a chart of this study.
class Looks {
public:
    explicit Looks(const Study& study);
    [[nodiscard]] viz::Look of(const std::string& technique, const std::string& precision, bool peer) const;
    [[nodiscard]] viz::Color color(const std::string& technique) const { return colors_.at(technique); }
    /// The colours of these techniques, then the markers of these precisions, with headings.
    [[nodiscard]] std::vector<std::pair<std::string, viz::Look>> legend(const std::vector<std::string>& techniques,
                                                                        const std::vector<std::string>& precisions) const;

private:
    std::map<std::string, viz::Color> colors_;
    std::vector<std::string> others_;  ///< precisions that are no rungs
};

/// Second line under a title: device, size, and the command that draws it.
std::string provenance(const Study& study, const std::string& size);

NamedFigure overviewFigure(const Study& study, const Looks& looks);
std::vector<NamedFigure> errorTimeFigures(const Study& study, const Looks& looks);
std::vector<NamedFigure> ladderFigures(const Study& study, const Looks& looks);
std::vector<NamedFigure> scalingFigures(const Study& study, const Looks& looks);
std::vector<NamedFigure> pathFigures(const Study& study, const Looks& looks);
std::vector<NamedFigure> distanceFigures(const Study& study, const Looks& looks);

}  // namespace gno::report
