// SPDX-License-Identifier: MIT
#include "validation/study/report/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_min/error.hpp"
#include "host_min/output/record.hpp"
#include "validation/study/report/statistics.hpp"
#include "validation/study/results_file.hpp"

namespace gno::report {
namespace {

using nlohmann::ordered_json;

/// A row that the report cannot use; the text says what is the matter.
struct NoRow : std::runtime_error {
    using std::runtime_error::runtime_error;
};

std::vector<double> times(const ordered_json& values, const std::string& what) {
    auto numbers = values.get<std::vector<double>>();
    for (const double ms : numbers)
        if (!std::isfinite(ms) || ms < 0) throw NoRow(what + " holds a time that is none");
    return numbers;
}

std::map<std::string, uint64_t> numbers(const ordered_json& json, const char* key) {
    std::map<std::string, uint64_t> found;
    if (json.contains(key))
        for (const auto& [name, value] : json.at(key).items())
            if (value.is_number()) found[name] = value.is_number_unsigned() ? value.get<uint64_t>() : uint64_t(std::max(0.0, value.get<double>()));
    return found;
}

CheckedSamples readCheck(const ordered_json& json) {
    CheckedSamples check;
    check.checked = json.at("checked");
    check.wrong = json.at("wrong");
    check.leaks = json.at("leaks");
    check.falseDark = json.at("false_dark");
    if (check.wrong > check.checked) throw NoRow("more samples are wrong than were checked");
    if (!json.contains("distance")) return check;
    const ordered_json& distance = json.at("distance");
    check.distanceFrom = distance.at("pixels").get<std::vector<double>>();
    check.distanceCounts = distance.at("samples").get<std::vector<uint64_t>>();
    if (check.distanceFrom.size() != check.distanceCounts.size()) throw NoRow("check.distance: pixels and samples differ in length");
    if (distance.contains("max") && distance.at("max").is_number()) check.distanceMax = distance.at("max");
    return check;
}

void readMeasurements(const ordered_json& json, Row& row) {
    row.totalMs = times(json.at("total_ms"), "total_ms");
    row.floorMs = times(json.at("floor_ms"), "floor_ms");
    if (row.totalMs.empty() || row.floorMs.empty()) throw NoRow("no repeat was timed");
    if (!(median(row.floorMs) > 0)) throw NoRow("the bare pass took no time");
    for (const ordered_json& pass : json.at("passes")) row.passes.push_back({pass.at("name"), times(pass.at("ms"), "a pass")});
    row.samples = json.at("samples");
    row.bytes = numbers(json, "bytes");
    row.counters = numbers(json, "counters");
    if (json.contains("check") && json.at("check").is_object()) row.check = readCheck(json.at("check"));
    if (json.contains("pictures"))
        for (const auto& [name, path] : json.at("pictures").items()) row.pictures[name] = path.get<std::string>();
}

Row readRow(const ordered_json& json) {
    Row row;
    row.job = json.at("job");
    row.group = json.at("group");
    row.run = json.value("run", "");
    row.scene = json.value("scene", "");
    row.name = json.at("name");
    row.camera = json.value("camera", 0u);
    row.frame = json.value("frame", 0u);
    row.light = json.value("light", 0u);
    row.lightKind = json.value("light_kind", "");
    row.cull = json.value("cull", "");
    row.technique = json.at("technique");
    row.precision = json.value("precision", "");
    row.peer = json.value("peer", false);
    row.bestOf = json.value("best_of", "");
    row.unavailable = json.value("unavailable", "");
    if (json.contains("settings")) row.settings = json.at("settings");
    if (json.contains("varied")) row.varied = json.at("varied").get<std::vector<std::string>>();
    if (json.contains("device"))
        row.device = fmt::format("{}, subgroup {}", json.at("device").value("driver", json.at("device").value("name", "")),
                                 json.at("device").value("subgroup", 0));
    row.size = json.at("size").get<std::array<uint32_t, 2>>();
    row.triangles = json.value("triangles", uint64_t{0});
    row.casters = json.value("casters", uint64_t{0});
    if (row.isMeasured()) readMeasurements(json, row);
    return row;
}

}  // namespace

uint64_t Row::totalBytes() const {
    uint64_t sum = 0;
    for (const auto& [bufferName, count] : bytes) sum += count;
    return sum;
}

uint64_t Row::counter(const std::string& counterName) const {
    const auto found = counters.find(counterName);
    return found == counters.end() ? 0 : found->second;
}

std::vector<double> Row::toFloor(const std::vector<double>& ms) const {
    std::vector<double> quotients;
    for (const double time : ms) quotients.push_back(time / median(floorMs));
    return quotients;
}

std::vector<double> Row::queryMs() const {
    std::vector<double> sums(totalMs.size(), 0.0);
    for (const TimedPass& pass : passes)
        if (!host::isBuildPass(pass.name))
            for (size_t i = 0; i < std::min(sums.size(), pass.ms.size()); ++i) sums[i] += pass.ms[i];
    return sums;
}

Results loadResults(const std::filesystem::path& file) {
    study::ReadResults read = study::readResults(file);
    Results results;
    results.file = file;
    std::map<std::string, size_t> byJob;
    for (size_t i = 0; i < read.rows.size(); ++i) {
        try {
            Row row = readRow(read.rows[i]);
            row.line = read.lines[i];
            const auto [place, isNew] = byJob.try_emplace(row.job, results.rows.size());
            if (isNew)
                results.rows.push_back(std::move(row));
            else if (row.isMeasured() || !results.rows[place->second].isMeasured())
                results.rows[place->second] = std::move(row);
        } catch (const std::exception& error) {  // a key that is missing or of another type, or NoRow
            const std::string text = error.what();
            read.problems.push_back({read.lines[i], text.substr(text.find("] ") == std::string::npos ? 0 : text.find("] ") + 2)});
        }
    }
    std::stable_sort(read.problems.begin(), read.problems.end(), [](const auto& a, const auto& b) { return a.line < b.line; });
    for (const study::Problem& problem : read.problems) results.problems.push_back(study::textOf(problem) + "; left out");
    if (!results.rows.empty()) return results;
    if (results.problems.empty()) throw host::InputError(fmt::format("'{}' is empty: run a sweep first", file.string()));
    throw host::InputError(fmt::format("'{}' holds no row of a study ({})", file.string(), results.problems.front()));
}

}  // namespace gno::report
