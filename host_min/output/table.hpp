// SPDX-License-Identifier: MIT
// What a person reads in the terminal: the records as a table, and a progress line.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host_min/output/record.hpp"

namespace gno::host {

/// One table per scene, frame and light, in the order of the records; numbers right-justified; the last columns only where a record has a check.
/// "x fastest" is total / the least total of the same table, "x floor" total / floor_ms, "-" where a time is missing. `color`: ANSI colours (wrong >
/// 0 red, fastest green).
[[nodiscard]] std::string formatTable(std::span<const Record> records, bool color);

/// The cells of formatTable without title and layout: row 0 holds the column names. For one scene, frame and light.
[[nodiscard]] std::vector<std::vector<std::string>> tableCells(std::span<const Record> records);

/// True when `fd` (1: standard output, 2: standard error) is a terminal and NO_COLOR and TERM=dumb do not forbid colour.
[[nodiscard]] bool wantsColor(int fd);

/// One line on standard error that is rewritten in place, at most ten times a second; silent when standard error is no terminal.
class Progress {
public:
    Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();  ///< wipes the line

    /// `what` is being done; `fraction` in [0, 1], or negative when nobody knows.
    void show(std::string_view what, double fraction = -1);
    /// Wipes the line, so that something else can be printed.
    void clear();

private:
    bool terminal_ = false, shown_ = false;
    long long lastNs_ = 0;
    std::string lastWhat_;
};

}  // namespace gno::host
