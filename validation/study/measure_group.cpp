// SPDX-License-Identifier: MIT
#include "validation/study/measure_group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>

#include "host_min/error.hpp"
#include "validation/study/best.hpp"
#include "validation/study/scenes.hpp"

namespace gno::study {
namespace {

constexpr uint64_t kRunsOfSearch = 20;

/// A variant while its group is being measured.
struct Entry {
    const Variant* variant;
    std::string bestValue;
    std::string unavailable;  ///< why; empty: it is there
    Row facts;                ///< of the first run: size to check
    Row pictures;
    std::vector<std::string> passNames;
    std::vector<std::vector<double>> passMs;  ///< by pass, then by repeat
    std::vector<double> totalMs;
};

double rounded(double value) { return std::round(value * 1e6) / 1e6; }

Row rounded(const std::vector<double>& values) {
    Row list = Row::array();
    for (const double value : values) list.push_back(rounded(value));
    return list;
}

std::vector<double> ratios(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> values;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) values.push_back(a[i] / b[i]);
    return values;
}

/// `work`, with a failure that concerns this one piece of work as its text; empty: none.
template <class Work>
std::string failureOf(const Work& work) {
    try {
        work();
        return {};
    } catch (const host::InputError& error) {
        return error.what();
    } catch (const host::MemoryError& error) {
        return error.what();
    } catch (const std::bad_alloc&) {
        return "no memory left";
    }
}

Row head(const GroupJobs& jobs, const Variant& variant, const std::string& run, host::Light::Kind kind, const host::Device& device) {
    const Group& group = jobs.group;
    Row row = {{"schema", kResultsSchema}, {"kind", kResultsKind}, {"job", jobKey(group, variant)}, {"group", group.key()}, {"run", run}};
    row["scene"] = group.scene;
    row["name"] = sceneName(group.scene);
    if (const auto made = generatedScene(group.scene))
        row["generated"] = {{"name", made->kind}, {"triangles", made->triangles}, {"seed", GeneratedScene::kSeed}};
    row["camera"] = group.camera;
    row["frame"] = group.frame;
    row["light"] = group.light;
    row["light_kind"] = kind == host::Light::Kind::point ? "point" : kind == host::Light::Kind::spot ? "spot" : "directional";
    row["cull"] = group.cull;
    row["technique"] = variant.technique;
    row["precision"] = variant.precision;
    row["settings"] = variant.settings({});
    row["varied"] = variant.varied({});
    row["peer"] = variant.peer;
    if (!variant.bestOf.empty()) row["best_of"] = variant.bestOf;
    const host::DeviceFacts& facts = device.facts();
    row["device"] = {
        {"name", facts.deviceName}, {"driver", fmt::format("{} {}", facts.driverName, facts.driverInfo)}, {"subgroup", facts.subgroupSize}};
    row["size"] = {group.width, group.height};
    return row;
}

/// A folder that cannot be written is no fault of the technique's.
Row written(GroupPictures& pictures, const Row& row, const host::TechniqueResult& result) {
    try {
        return pictures.write(row, result);
    } catch (const host::InputError& error) {
        throw host::WorkError(error.what());
    }
}

/// The run with counters: its answers, not its times.
void firstRun(Subject& subject, Entry& entry, Row& row, Worst& worst, GroupPictures& pictures, const Report& report) {
    const Variant& variant = *entry.variant;
    const std::string label = fmt::format("{} {}", variant.technique, variant.precision);
    if (!variant.bestOf.empty()) {
        for (const host::SettingInfo& info : host::techniqueByName(variant.technique).info().settings) {
            if (info.key != variant.bestOf) continue;
            entry.bestValue = bestValue(info, [&](const std::string& value) {
                report(fmt::format("{} {}={}", label, info.key, value), 1);
                return subject.compare(subject.run(variant, value, false), nullptr).wrong;
            });
        }
    }
    report(label, 1);
    const host::TechniqueResult result = subject.run(variant, entry.bestValue, true);
    host::Record record = host::makeRecord(subject.inputs(), result);
    std::vector<uint32_t> wrongPixels;
    record.check = subject.compare(result, &wrongPixels);
    const DistanceHistogram distance = subject.distances(result, wrongPixels);
    entry.facts = host::toJson(record);
    if (variant.peer) entry.facts["counters"] = Row::object();
    entry.facts["check"]["distance"] = {
        {"pixels", distance.lowerEnds}, {"samples", distance.samples}, {"max", rounded(distance.max)}, {"mean", rounded(distance.mean)}};
    row["settings"] = variant.settings(entry.bestValue);
    row["varied"] = variant.varied(entry.bestValue);
    row["check"] = entry.facts["check"];
    if (worst.isWorse(row)) entry.pictures = written(pictures, row, result);
    row.erase("check");
    for (const host::RecordPass& pass : result.passes) entry.passNames.push_back(pass.name);
    entry.passMs.resize(entry.passNames.size());
}

void timedRun(const Subject& subject, Entry& entry) {
    const host::TechniqueResult result = subject.run(*entry.variant, entry.bestValue, false);
    double total = 0;
    for (size_t i = 0; i < entry.passNames.size(); ++i) {
        entry.passMs[i].push_back(result.passes.at(i).ms);
        total += result.passes[i].ms;
    }
    entry.totalMs.push_back(total);
}

void finish(Row& row, const Entry& entry, const std::vector<double>& floorMs, const std::vector<double>& fastest) {
    for (const char* key : {"triangles", "casters", "samples", "in_shadow"}) row[key] = entry.facts[key];
    row["floor_ms"] = rounded(floorMs);
    row["passes"] = Row::array();
    for (size_t i = 0; i < entry.passNames.size(); ++i) row["passes"].push_back({{"name", entry.passNames[i]}, {"ms", rounded(entry.passMs[i])}});
    row["total_ms"] = rounded(entry.totalMs);
    row["ratio_to_floor"] = rounded(median(ratios(entry.totalMs, floorMs)));
    row["ratio_to_fastest"] = rounded(median(ratios(entry.totalMs, fastest)));
    for (const char* key : {"bytes", "counters", "check"}) row[key] = entry.facts[key];
    if (!entry.pictures.is_null()) row["pictures"] = entry.pictures;
}

}  // namespace

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

uint64_t runsOf(const GroupJobs& jobs) {
    uint64_t runs = 0;
    for (const Variant& variant : jobs.variants) runs += 1 + jobs.repeat + (variant.bestOf.empty() ? 0 : kRunsOfSearch);
    return runs;
}

std::vector<Row> measureGroup(host::PassCache& passes, const host::SceneFile& file, const GroupJobs& jobs, const std::string& run, Worst& worst,
                              const std::filesystem::path& folder, const Report& report) {
    std::vector<Row> rows;
    std::vector<Entry> entries;
    bool withSums = false;
    const host::Light::Kind kind = file.evaluate(jobs.group.frame, jobs.group.camera).lights.at(jobs.group.light).kind;
    for (const Variant& variant : jobs.variants) {
        rows.push_back(head(jobs, variant, run, kind, passes.device()));
        entries.push_back({&variant, {}, {}, {}, {}, {}, {}, {}});
        withSums = withSums || (!variant.peer && host::answersForMaterials(host::techniqueByName(variant.technique).info()));
    }
    const auto available = [&](const auto& work) {
        for (size_t i = 0; i < entries.size(); ++i)
            if (entries[i].unavailable.empty()) entries[i].unavailable = failureOf([&] { work(entries[i], rows[i]); });
    };
    std::optional<Subject> subject;
    report("scene", 0);
    const std::string failure = failureOf([&] { subject.emplace(passes, file, jobs.group, withSums, report); });
    for (Entry& entry : entries) entry.unavailable = failure;
    std::vector<double> floorMs;
    if (subject) {
        GroupPictures pictures(*subject, folder);
        available([&](Entry& entry, Row& row) { firstRun(*subject, entry, row, worst, pictures, report); });
        for (uint32_t repeat = 0; repeat < jobs.repeat; ++repeat) {
            floorMs.push_back(subject->repeatFloor());
            available([&](Entry& entry, Row&) {
                report(fmt::format("{} {}, repeat {}", entry.variant->technique, entry.variant->precision, repeat + 1), 1);
                timedRun(*subject, entry);
            });
        }
    }
    const Entry* fastest = nullptr;
    for (const Entry& entry : entries)
        if (entry.unavailable.empty() && (!fastest || median(entry.totalMs) < median(fastest->totalMs))) fastest = &entry;
    for (size_t i = 0; i < rows.size(); ++i) {
        if (entries[i].unavailable.empty())
            finish(rows[i], entries[i], floorMs, fastest->totalMs);
        else
            rows[i]["unavailable"] = entries[i].unavailable;
    }
    return rows;
}

}  // namespace gno::study
