// SPDX-License-Identifier: MIT
#include "validation/hard_cases/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_min/error.hpp"

namespace gno::hard {
namespace {

constexpr const char* kBegin = "<!-- hard cases: begin -->\n";
constexpr const char* kEnd = "<!-- hard cases: end -->";

/// The rungs that a cell holds a value for: those of the first technique.
std::vector<host::Precision> rungsOf(const CaseResult& result) {
    std::vector<host::Precision> rungs;
    for (const Tally& tally : result.tallies)
        if (tally.technique == result.tallies.front().technique) rungs.push_back(tally.precision);
    return rungs;
}

/// One row: the first cells, then one cell per technique with a value per rung, such as "18 / 0 / 0"; "-" for one that it lacks, or a run that was
/// refused.
template <class Value>
std::string cells(const CaseResult& result, const Value& value) {
    std::string row;
    for (auto first = result.tallies.begin(); first != result.tallies.end();) {
        const auto last = std::find_if(first, result.tallies.end(), [&](const Tally& tally) { return tally.technique != first->technique; });
        const char* before = " | ";
        for (const host::Precision rung : rungsOf(result)) {
            const auto tally = std::find_if(first, last, [&](const Tally& t) { return t.precision == rung; });
            row += before + (tally == last || !tally->refused.empty() ? "-" : value(*tally));
            before = " / ";
        }
        first = last;
    }
    return row + " |\n";
}

std::string header(const CaseResult& result, const char* first) {
    std::string names, rule;
    std::string technique;
    for (const Tally& tally : result.tallies) {
        if (tally.technique == technique) continue;
        technique = tally.technique;
        names += " | " + technique;
        rule += " ---: |";
    }
    return fmt::format("| {}{} |\n| --- | ---: | ---: |{}\n", first, names, rule);
}

std::string rungs(const CaseResult& result) {
    std::string text;
    for (const host::Precision rung : rungsOf(result)) text += (text.empty() ? "" : " / ") + std::string(host::name(rung));
    return text;
}

}  // namespace

std::string markdown(std::span<const CaseResult> results, const RunnerOptions& options) {
    if (results.empty()) return "No case.\n";
    const host::DeviceFacts& device = test::passes().device().facts();
    std::string text = fmt::format(
        "Made by `gnomon-hard-cases --seeds {}{}` on {}, {} {}, subgroup width {}. `gnomon-hard-cases --list` says why a case is hard. A cell holds "
        "{}.\n\n"
        "Wrong answers, all scenes and insertion seeds of a case together; \"answers\" is how many there were.\n\n",
        options.insertionSeeds, options.uncertified ? " --uncertified" : "", device.deviceName, device.driverName, device.driverInfo,
        device.subgroupSize, rungs(results.front()));
    text += header(results.front(), "case | triangles | answers");
    for (const CaseResult& result : results)
        text += fmt::format("| {} | {} | {}", result.hardCase->name, result.triangles, result.tallies.front().answers) +
                cells(result, [](const Tally& tally) { return std::to_string(tally.wrong); });
    if (options.counters) {
        text += "\nVisited nodes per sample, and the share of samples in shadow.\n\n" + header(results.front(), "case | triangles | in shadow");
        for (const CaseResult& result : results)
            text += fmt::format("| {} | {} | {:.0f} %", result.hardCase->name, result.triangles,
                                100.0 * double(result.inShadow) / double(result.samples)) +
                    cells(result, [](const Tally& tally) { return fmt::format("{:.1f}", double(tally.visitedNodes) / double(tally.answers)); });
    }
    return text;
}

std::string replaceSection(const std::string& text, const std::string& section) {
    const size_t begin = text.find(kBegin);
    const size_t end = begin == std::string::npos ? begin : text.find(kEnd, begin);
    if (end == std::string::npos)
        throw host::InputError(
            "the file to update has no lines <!-- hard cases: begin --> and <!-- hard cases: end -->: add them where the tables belong");
    return text.substr(0, begin) + kBegin + section + text.substr(end);
}

}  // namespace gno::hard
