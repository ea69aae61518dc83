// SPDX-License-Identifier: MIT
// The record: what one frame, light, technique and precision cost and gave. Its keys are a contract (schema 2, README "The record").
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace gno::host {

/// Names with numbers, in the order in which they are written.
using NamedNumbers = std::vector<std::pair<std::string, uint64_t>>;

struct RecordDevice {
    std::string name, driver;
    uint32_t subgroup = 0;
};

struct RecordPass {
    std::string name;
    double ms = 0;  ///< device time, median over the repeats; NaN: the device has no time stamps
};

/// From a separate instrumented run. The six of the contract are always written; `more` follows them (vertices, quads, ...).
struct RecordCounters {
    uint64_t visitedNodes = 0, maxStack = 0, stackOverflows = 0, exactCalls = 0, dropped = 0, testAndSet = 0;
    NamedNumbers more;
};

/// What putting positions on the grid did to the picture (scene.hpp, GridHarm).
struct RecordGrid {
    std::array<double, 3> origin{};  ///< world units
    double step = 0;                 ///< positions are multiples of it, world units
    double movedPixels = 0, lightArcsec = 0;
    bool changed = false;  ///< another grid than that of the frame before
};

struct RecordCheck {
    uint64_t checked = 0, wrong = 0, leaks = 0, falseDark = 0;
    uint64_t self = 0;     ///< samples that only their own primitive would darken
    uint64_t witness = 0;  ///< samples where the fp32 witness differs from the exact answer
};

struct Record {
    std::string scene;
    uint32_t frame = 0, light = 0;
    nlohmann::ordered_json animation;  ///< number of the applied one, or "all"; null: the file has none
    std::string technique, precision;
    nlohmann::ordered_json settings = nlohmann::ordered_json::object();  ///< of `--set`: name and value, defaults included
    RecordDevice device;
    std::array<uint32_t, 2> size{};
    RecordGrid grid;
    uint64_t triangles = 0;       ///< in the scene
    uint64_t casters = 0;         ///< left after culling
    uint64_t takenForOpaque = 0;  ///< triangles in the scene that are alpha-tested or coloured, where the technique does not look
    uint64_t samples = 0, inShadow = 0;
    uint64_t unknown = 0;            ///< samples that the technique had no answer for: a structure was not complete
    std::vector<RecordPass> passes;  ///< total_ms is their sum
    std::optional<double> floorMs;   ///< time of a bare full-screen pass, where it was measured; NaN as above
    NamedNumbers bytes;
    RecordCounters counters;
    uint64_t hostWaits = 0;            ///< within a frame: the host waits for the device and goes on with what it read; their time is in the passes
    uint64_t reruns = 0;               ///< frames thrown away because a pool was too small
    std::optional<RecordCheck> check;  ///< with --check only
    std::vector<std::string> effects;

    /// Sum of the passes whose name satisfies the table's idea of a build (`isBuildPass`), of the others, and of all; ms. NaN when one is.
    [[nodiscard]] double buildMs() const;
    [[nodiscard]] double queryMs() const;
    [[nodiscard]] double totalMs() const;
};

/// True for what prepares a structure: a pass called "build" or "setup", or with "build" or "setup" as a part between underscores; and host_wait.
[[nodiscard]] bool isBuildPass(const std::string& name);

/// The object of the contract, keys in its order. A time that is missing (NaN) is null, one that is infinite throws std::invalid_argument; text that
/// is not UTF-8 is repaired.
[[nodiscard]] nlohmann::ordered_json toJson(const Record& record);

/// toJson(record) on one line, no line end.
[[nodiscard]] std::string toJsonLine(const Record& record);

/// JSON Lines, one record a line, replaced as a whole. Throws InputError or WorkError like AtomicFile.
void writeRecords(const std::filesystem::path& path, std::span<const Record> records);

}  // namespace gno::host
