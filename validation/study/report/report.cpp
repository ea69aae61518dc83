// SPDX-License-Identifier: MIT
#include "validation/study/report/report.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "host_min/interrupt.hpp"
#include "host_min/output/atomic_file.hpp"
#include "validation/study/report/page.hpp"
#include "viz/display.hpp"

namespace gno::report {
namespace {

std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write(const std::filesystem::path& path, const std::string& bytes) {
    host::AtomicFile file(path);
    file.stream().write(bytes.data(), std::streamsize(bytes.size()));
    file.commit();
}

/// Of each technique the row with the greatest share of wrong samples among those with pictures. A picture that cannot be read is a problem told.
std::vector<WorstFrame> worstFrames(Study& study) {
    std::vector<WorstFrame> frames;
    const std::filesystem::path folder = study.results.file.parent_path();
    for (const std::string& technique : study.techniques) {
        const Row* worst = nullptr;
        const auto share = [](const Row& row) { return double(row.check->wrong) / double(row.check->checked); };
        for (const Row& row : study.results.rows)
            if (row.technique == technique && row.check && row.check->wrong > 0 && row.pictures.contains("shaded") &&
                row.pictures.contains("truth") && (worst == nullptr || share(row) > share(*worst)))
                worst = &row;
        if (worst == nullptr) continue;
        WorstFrame frame{worst, {}, {}, {}};
        for (const auto& [name, bytes] : {std::pair{"shaded", &frame.shaded}, {"truth", &frame.truth}, {"wrong", &frame.wrong}}) {
            const auto found = worst->pictures.find(name);
            if (found == worst->pictures.end()) continue;
            *bytes = contents(folder / found->second);
            if (bytes->empty())
                study.results.problems.push_back(fmt::format("line {}: cannot read its picture '{}'", worst->line, found->second.string()));
        }
        if (!frame.shaded.empty() && !frame.truth.empty()) frames.push_back(std::move(frame));
    }
    return frames;
}

std::vector<NamedFigure> figuresOf(const Study& study) {
    const Looks looks(study);
    std::vector<NamedFigure> figures;
    NamedFigure overview = overviewFigure(study, looks);
    if (overview.figure.panels[0].series.size() > 2) figures.push_back(std::move(overview));  // more than a front and its labels
    for (const auto make : {errorTimeFigures, ladderFigures, scalingFigures, pathFigures, distanceFigures})
        for (NamedFigure& figure : make(study, looks)) figures.push_back(std::move(figure));
    return figures;
}

}  // namespace

void report(const ReportOptions& options) {
    Study study = arrange(loadResults(options.results));
    host::makeFolder(options.out);
    { const host::AtomicFile probe(options.out / "index.html"); }  // before the work and not after it
    const viz::Display display;
    const std::vector<WorstFrame> worst = worstFrames(study);
    for (const std::string& problem : study.results.problems) fmt::print(stderr, "gnomon-study: {}: {}\n", options.results.string(), problem);
    std::vector<DrawnFigure> drawn;
    for (NamedFigure& figure : figuresOf(study)) {
        host::throwIfInterrupted();
        std::string png = viz::drawPng(figure.figure);
        write(options.out / (figure.file + ".png"), png);
        drawn.push_back({std::move(figure), std::move(png)});
    }
    write(options.out / "index.html", makePage(study, drawn, worst));
    fmt::print("{}: {} rows, {} charts\n", (options.out / "index.html").string(), study.results.rows.size(), drawn.size());
}

}  // namespace gno::report
