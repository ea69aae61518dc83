// SPDX-License-Identifier: MIT
// The rows of a study, understood for the report: results_file.hpp reads them. Format: validation/README.md "The study".
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace gno::report {

struct TimedPass {
    std::string name;
    std::vector<double> ms;  ///< one a repeat
};

struct CheckedSamples {
    uint64_t checked = 0, wrong = 0, leaks = 0, falseDark = 0;
    std::vector<double> distanceFrom;      ///< lower ends of the histogram's bins, pixels
    std::vector<uint64_t> distanceCounts;  ///< wrong samples a bin
    double distanceMax = 0;
};

struct Row {
    size_t line = 0;  ///< of the file, from 1
    std::string job, group, run, scene, name, lightKind, cull, technique, precision, bestOf, device, unavailable;
    uint32_t camera = 0, frame = 0, light = 0;
    bool peer = false;
    nlohmann::ordered_json settings = nlohmann::ordered_json::object();
    std::vector<std::string> varied;
    std::array<uint32_t, 2> size{};
    uint64_t triangles = 0, casters = 0, samples = 0;
    std::vector<double> floorMs, totalMs;  ///< one a repeat
    std::vector<TimedPass> passes;
    std::map<std::string, uint64_t> bytes, counters;
    std::optional<CheckedSamples> check;
    std::map<std::string, std::filesystem::path> pictures;  ///< shaded, truth, wrong; paths from the folder of the file

    [[nodiscard]] bool isMeasured() const { return unavailable.empty(); }
    [[nodiscard]] uint64_t totalBytes() const;
    [[nodiscard]] uint64_t counter(const std::string& counterName) const;  ///< 0: not counted
    /// Times of a repeat each, as ratios to the bare full-screen pass: to the median of its own repeats, because it is so short that one stolen
    /// time slice makes it ten times as long.
    [[nodiscard]] std::vector<double> toFloor(const std::vector<double>& ms) const;
    [[nodiscard]] std::vector<double> queryMs() const;  ///< a repeat each: all passes that do not build
};

struct Results {
    std::filesystem::path file;
    std::vector<Row> rows;              ///< the last of each job; a job measured after it was unavailable counts as measured
    std::vector<std::string> problems;  ///< lines that were left out and why, one line each
};

/// Throws InputError: no such file, not readable, or no row in it.
Results loadResults(const std::filesystem::path& file);

}  // namespace gno::report
