// SPDX-License-Identifier: MIT
// The results of a study: JSON Lines, one row a line, appended to. What is there is never changed by a run, whatever stops it.
#pragma once
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace gno::study {

using Row = nlohmann::ordered_json;

inline constexpr int kResultsSchema = 1;
inline constexpr const char* kResultsKind = "gnomon-study";

/// A line that is left out.
struct Problem {
    uint64_t line = 0;  ///< from 1
    std::string why;
};
std::string textOf(const Problem& problem);  ///< "line 3: not JSON"

struct ReadResults {
    std::vector<Row> rows;
    std::vector<uint64_t> lines;  ///< a row each: where it stands, from 1
    std::vector<Problem> problems;
    uint64_t goodBytes = 0;  ///< up to the end of the last line that is whole, its line end included
    std::string brokenEnd;   ///< what follows them
    bool endsOpen = false;   ///< the last row is whole, but its line end is missing
};

/// The one reader of this file: a run that goes on, merge and report. Blank lines are no problem. Throws InputError: no such file, no right to read
/// it, or not a results file at all.
ReadResults readResults(const std::filesystem::path& path);

class ResultsFile {
public:
    /// Opens or makes it and locks it. A broken last line goes into PATH.broken, so that no row is ever glued to it; notes() tell. Throws
    /// InputError: cannot be written, another process writes it, or it is not a results file; WorkError.
    explicit ResultsFile(const std::filesystem::path& path);
    ResultsFile(const ResultsFile&) = delete;
    ResultsFile& operator=(const ResultsFile&) = delete;
    ~ResultsFile();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path folder() const { return path_.has_parent_path() ? path_.parent_path() : std::filesystem::path("."); }
    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }  ///< those that were there
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
    [[nodiscard]] bool has(const std::string& job) const { return jobs_.contains(job); }

    /// All of them or none, on the disk when it returns. Throws WorkError.
    void append(std::span<const Row> rows);

private:
    std::filesystem::path path_;
    int file_ = -1;
    bool regular_ = true;
    std::vector<Row> rows_;
    std::vector<std::string> notes_;
    std::set<std::string> jobs_;
};

/// One row as its line, with line end.
std::string lineOf(const Row& row);

}  // namespace gno::study
