// SPDX-License-Identifier: MIT
#include "host_min/output/table.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "host_min/scene/one_line.hpp"

namespace gno::host {

namespace {

constexpr std::size_t kTextColumns = 2;  // technique and precision; the others are numbers
constexpr const char *kGreen = "\033[32m", *kRed = "\033[31m", *kYellow = "\033[33m", *kBold = "\033[1m", *kPlain = "\033[0m";

std::string ratio(double a, double b, const char* format) { return b > 0 && !std::isnan(a) ? fmt::format(fmt::runtime(format), a / b) : "-"; }

std::string milliseconds(double ms) { return std::isnan(ms) ? "-" : fmt::format("{:.2f}", ms); }

bool sameFrame(const Record& a, const Record& b) { return a.scene == b.scene && a.frame == b.frame && a.light == b.light && a.size == b.size; }

bool anyCheck(std::span<const Record> records) {
    return std::any_of(records.begin(), records.end(), [](const Record& record) { return record.check.has_value(); });
}

bool anyUnknown(std::span<const Record> records) {
    return std::any_of(records.begin(), records.end(), [](const Record& record) { return record.unknown > 0; });
}

bool anyTakenForOpaque(std::span<const Record> records) {
    return std::any_of(records.begin(), records.end(), [](const Record& record) { return record.takenForOpaque > 0; });
}

struct Extras {
    bool takenForOpaque, unknown, check;
};

std::vector<std::string> rowOf(const Record& record, double fastest, const Extras& with) {
    const RecordCounters& counters = record.counters;
    const auto samples = static_cast<double>(record.samples);
    const double total = record.totalMs();
    std::vector<std::string> row = {record.technique,
                                    record.precision,
                                    std::to_string(record.casters),
                                    ratio(100.0 * static_cast<double>(record.inShadow), samples, "{:.1f}"),
                                    ratio(static_cast<double>(counters.visitedNodes), samples, "{:.1f}"),
                                    std::to_string(counters.maxStack),
                                    std::to_string(counters.stackOverflows),
                                    milliseconds(record.buildMs()),
                                    milliseconds(record.queryMs()),
                                    milliseconds(total),
                                    ratio(total, fastest, "{:.2f}"),
                                    ratio(total, record.floorMs.value_or(0), "{:.1f}")};
    if (with.takenForOpaque) row.push_back(std::to_string(record.takenForOpaque));
    if (with.unknown) row.push_back(std::to_string(record.unknown));
    if (with.check) {
        const auto add = [&](uint64_t number) { row.push_back(record.check ? std::to_string(number) : "-"); };
        const RecordCheck check = record.check.value_or(RecordCheck{});
        add(check.wrong);
        add(check.leaks);
        add(check.falseDark);
    }
    return row;
}

const char* colorOf(const std::vector<std::string>& names, std::size_t column, const std::string& cell) {
    if (names[column] == "x fastest" && cell == "1.00") return kGreen;
    if (names[column] == "unknown" && cell != "0") return kRed;
    if (names[column] == "taken as opaque" && cell != "0") return kYellow;
    if (names[column] == "wrong" && cell != "-") return cell == "0" ? kGreen : kRed;
    return nullptr;
}

void appendRows(std::string& text, const std::vector<std::vector<std::string>>& cells, bool color) {
    std::vector<std::size_t> widths(cells.front().size(), 0);
    for (const auto& row : cells)
        for (std::size_t column = 0; column < row.size(); ++column) widths[column] = std::max(widths[column], row[column].size());
    for (std::size_t r = 0; r < cells.size(); ++r) {
        std::string line;
        for (std::size_t column = 0; column < cells[r].size(); ++column) {
            const std::string& cell = cells[r][column];
            std::string padded = column < kTextColumns ? fmt::format("{:<{}}", cell, widths[column]) : fmt::format("{:>{}}", cell, widths[column]);
            const char* start = !color ? nullptr : r == 0 ? kBold : colorOf(cells.front(), column, cell);
            if (start != nullptr) padded = start + padded + kPlain;
            line += (column == 0 ? "" : "  ") + padded;
        }
        while (!line.empty() && line.back() == ' ') line.pop_back();
        text += line + '\n';
    }
}

}  // namespace

std::vector<std::vector<std::string>> tableCells(std::span<const Record> records) {
    const Extras with{anyTakenForOpaque(records), anyUnknown(records), anyCheck(records)};
    std::vector<std::vector<std::string>> cells = {{"technique", "precision", "casters", "in shadow %", "visited/sample", "max stack", "overflows",
                                                    "build ms", "query ms", "total ms", "x fastest", "x floor"}};
    if (with.takenForOpaque) cells[0].push_back("taken as opaque");
    if (with.unknown) cells[0].push_back("unknown");
    if (with.check) cells[0].insert(cells[0].end(), {"wrong", "leaks", "false dark"});
    double fastest = 0;
    for (const Record& record : records)
        if (const double total = record.totalMs(); total > 0 && (fastest == 0 || total < fastest)) fastest = total;
    for (const Record& record : records) cells.push_back(rowOf(record, fastest, with));
    return cells;
}

std::string formatTable(std::span<const Record> records, bool color) {
    std::string text;
    while (!records.empty()) {
        const Record& first = records.front();
        const auto end = std::find_if_not(records.begin(), records.end(), [&](const Record& record) { return sameFrame(first, record); });
        const auto count = static_cast<std::size_t>(end - records.begin());
        if (!text.empty()) text += '\n';
        text += fmt::format("{}, frame {}, light {}: {}x{}, {}, {}\n", oneLine(first.scene), first.frame, first.light, first.size[0], first.size[1],
                            counted(first.triangles, "triangle"), counted(first.samples, "sample"));
        appendRows(text, tableCells(records.first(count)), color);
        if (anyCheck(records.first(count)))
            text += fmt::format(
                "wrong: against the definition on the grid; putting positions there moved what the camera sees by at most {:.2g} pixel\n",
                first.grid.movedPixels);
        records = records.subspan(count);
    }
    return text;
}

bool wantsColor(int fd) {
    const char* term = std::getenv("TERM");
    const char* noColor = std::getenv("NO_COLOR");
    return ::isatty(fd) != 0 && (noColor == nullptr || *noColor == '\0') && (term == nullptr || std::string_view(term) != "dumb");
}

}  // namespace gno::host
