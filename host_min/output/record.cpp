// SPDX-License-Identifier: MIT
#include "host_min/output/record.hpp"

#include <cmath>
#include <stdexcept>

#include "host_min/output/atomic_file.hpp"

namespace gno::host {

using nlohmann::ordered_json;

namespace {

/// Milliseconds to whole nanoseconds' worth of digits: what a time stamp can tell. NaN, where a device has none, is null.
ordered_json time(double ms) {
    if (std::isnan(ms)) return nullptr;
    if (!std::isfinite(ms)) throw std::invalid_argument("a record's time is not a finite number");
    return std::round(ms * 1e6) / 1e6;
}

void requireFinite(const ordered_json& value) {
    if (value.is_number_float() && !std::isfinite(value.get<double>())) throw std::invalid_argument("a record's setting is not a finite number");
    if (value.is_structured())
        for (const ordered_json& part : value) requireFinite(part);
}

void append(ordered_json& object, const NamedNumbers& numbers) {
    for (const auto& [name, number] : numbers) object[name] = number;
}

ordered_json countersJson(const RecordCounters& counters) {
    ordered_json json = {{"visited_nodes", counters.visitedNodes}, {"max_stack", counters.maxStack}, {"stack_overflows", counters.stackOverflows},
                         {"exact_calls", counters.exactCalls},     {"dropped", counters.dropped},    {"test_and_set", counters.testAndSet}};
    append(json, counters.more);
    return json;
}

}  // namespace

bool isBuildPass(const std::string& name) {
    const std::string framed = "_" + name + "_";
    return framed.find("_build_") != std::string::npos || framed.find("_setup_") != std::string::npos || name == "host_wait";
}

double Record::totalMs() const {
    double sum = 0;
    for (const RecordPass& pass : passes) sum += pass.ms;
    return sum;
}

double Record::buildMs() const {
    double sum = 0;
    for (const RecordPass& pass : passes) sum += isBuildPass(pass.name) ? pass.ms : 0;
    return sum;
}

double Record::queryMs() const {
    double sum = 0;
    for (const RecordPass& pass : passes) sum += isBuildPass(pass.name) ? 0 : pass.ms;
    return sum;
}

ordered_json toJson(const Record& record) {
    requireFinite(record.settings);
    ordered_json json;
    json["schema"] = 2;
    json["scene"] = record.scene;
    json["frame"] = record.frame;
    json["animation"] = record.animation;
    json["light"] = record.light;
    json["technique"] = record.technique;
    json["precision"] = record.precision;
    json["settings"] = record.settings.is_null() ? ordered_json::object() : record.settings;
    json["device"] = {{"name", record.device.name}, {"driver", record.device.driver}, {"subgroup", record.device.subgroup}};
    json["size"] = {record.size[0], record.size[1]};
    const RecordGrid& grid = record.grid;
    json["grid"] = {
        {"origin", grid.origin}, {"step", grid.step}, {"moved_px", grid.movedPixels}, {"light_arcsec", grid.lightArcsec}, {"changed", grid.changed}};
    requireFinite(json["grid"]);
    json["triangles"] = record.triangles;
    json["casters"] = record.casters;
    json["taken_for_opaque"] = record.takenForOpaque;
    json["samples"] = record.samples;
    json["in_shadow"] = record.inShadow;
    json["unknown"] = record.unknown;
    json["passes"] = ordered_json::array();
    for (const RecordPass& pass : record.passes) json["passes"].push_back({{"name", pass.name}, {"ms", time(pass.ms)}});
    json["total_ms"] = time(record.totalMs());
    if (record.floorMs) json["floor_ms"] = time(*record.floorMs);
    json["bytes"] = ordered_json::object();
    append(json["bytes"], record.bytes);
    json["counters"] = countersJson(record.counters);
    json["host_waits"] = record.hostWaits;
    json["reruns"] = record.reruns;
    if (record.check) {
        const RecordCheck& check = *record.check;
        json["check"] = {{"checked", check.checked},      {"wrong", check.wrong}, {"leaks", check.leaks},
                         {"false_dark", check.falseDark}, {"self", check.self},   {"witness", check.witness}};
    }
    json["effects"] = record.effects;
    return json;
}

std::string toJsonLine(const Record& record) { return toJson(record).dump(-1, ' ', false, ordered_json::error_handler_t::replace); }

void writeRecords(const std::filesystem::path& path, std::span<const Record> records) {
    AtomicFile file(path);
    for (const Record& record : records) file.stream() << toJsonLine(record) << '\n';
    file.commit();
}

}  // namespace gno::host
