// SPDX-License-Identifier: MIT
#include "validation/study/results_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

#include "host_min/error.hpp"

namespace gno::study {
namespace fs = std::filesystem;
namespace {

std::string reason(int error) { return std::generic_category().message(error); }

/// Why this line is no row of a study; empty: it is one.
std::string faultOf(const Row& row, bool isLast) {
    const auto isText = [&](const char* key) { return row.contains(key) && row[key].is_string(); };
    if (row.is_discarded()) return isLast ? "broken off in the middle, as an interrupt leaves it" : "not JSON";
    if (!row.is_object() || !isText("kind") || row["kind"] != kResultsKind) return fmt::format("not a row of {}", kResultsKind);
    if (!row.contains("schema") || row["schema"] != kResultsSchema)
        return fmt::format("its schema is not {}: a newer {} wrote it", kResultsSchema, kResultsKind);
    return isText("job") ? "" : "it names no job";
}

/// 0 or errno.
int writeAll(int file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(file, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return written < 0 ? errno : ENOSPC;
        text.remove_prefix(size_t(written));
    }
    return 0;
}

}  // namespace

std::string textOf(const Problem& problem) { return fmt::format("line {}: {}", problem.line, problem.why); }

std::string lineOf(const Row& row) { return row.dump(-1, ' ', false, Row::error_handler_t::replace) + "\n"; }

ReadResults readResults(const fs::path& path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) throw host::InputError(fmt::format("cannot read '{}': it is a folder", path.string()));
    std::ifstream file(path, std::ios::binary);
    std::stringstream stream;
    if (!file || (stream << file.rdbuf(), file.bad())) throw host::InputError(fmt::format("cannot read '{}': {}", path.string(), reason(errno)));
    const std::string text = stream.str();
    ReadResults results;
    for (size_t begin = 0, number = 1; begin < text.size(); ++number) {
        const size_t end = text.find('\n', begin), next = end == std::string::npos ? text.size() : end + 1;
        const std::string_view line = std::string_view(text).substr(begin, (end == std::string::npos ? text.size() : end) - begin);
        const bool isBlank = line.find_first_not_of(" \t\r") == std::string_view::npos, isLast = next == text.size();
        Row row = isBlank ? Row() : Row::parse(line, nullptr, false);
        const std::string fault = isBlank ? "" : faultOf(row, isLast);
        if (!fault.empty()) results.problems.push_back({number, fault});
        if (!fault.empty() && isLast)
            results.brokenEnd = text.substr(begin);
        else
            results.goodBytes = next;
        if (fault.empty() && !isBlank) {
            results.rows.push_back(std::move(row));
            results.lines.push_back(number);
            results.endsOpen = end == std::string::npos;
        }
        begin = next;
    }
    const size_t broken = results.problems.size();
    if (results.rows.empty() && (broken > 1 || (broken == 1 && results.brokenEnd.find(kResultsKind) == std::string::npos)))
        throw host::InputError(fmt::format("'{}' holds no row of a study ({}): name another file", path.string(), textOf(results.problems.front())));
    return results;
}

ResultsFile::ResultsFile(const fs::path& path) : path_(path) {
    file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file_ < 0)
        throw host::InputError(
            fmt::format("cannot write '{}': {}; name a file in an existing folder that you may write to", path.string(), reason(errno)));
    try {
        struct stat status {};
        regular_ = ::fstat(file_, &status) == 0 && S_ISREG(status.st_mode);
        if (!regular_) return;
        if (::flock(file_, LOCK_EX | LOCK_NB) != 0)
            throw host::InputError(fmt::format("'{}' is being written by another run: wait for it, or name another file", path.string()));
        ReadResults read = readResults(path);
        for (const Problem& problem : read.problems) notes_.push_back(fmt::format("{}: {}", path.string(), textOf(problem)));
        if (!read.brokenEnd.empty()) {
            const fs::path aside = path.string() + ".broken";
            std::ofstream kept(aside, std::ios::binary | std::ios::app);
            kept << read.brokenEnd << (read.brokenEnd.ends_with('\n') ? "" : "\n");
            kept.close();
            if (!kept) throw host::WorkError(fmt::format("cannot write '{}'", aside.string()));
            if (::ftruncate(file_, off_t(read.goodBytes)) != 0)
                throw host::WorkError(fmt::format("cannot write '{}': {}", path.string(), reason(errno)));
            notes_.back() += fmt::format("; moved to {}", aside.string());
        }
        if (read.endsOpen)
            if (const int error = writeAll(file_, "\n")) throw host::WorkError(fmt::format("cannot write '{}': {}", path.string(), reason(error)));
        rows_ = std::move(read.rows);
        for (const Row& row : rows_) jobs_.insert(row["job"].get<std::string>());
    } catch (...) {
        ::close(file_);
        throw;
    }
}

ResultsFile::~ResultsFile() { ::close(file_); }

void ResultsFile::append(std::span<const Row> rows) {
    std::string text;
    for (const Row& row : rows) text += lineOf(row);
    const off_t before = regular_ ? ::lseek(file_, 0, SEEK_END) : 0;
    int error = writeAll(file_, text);
    if (error == 0 && regular_ && ::fdatasync(file_) != 0) error = errno;
    if (error != 0) {
        const bool restored = !regular_ || ::ftruncate(file_, before) == 0;
        throw host::WorkError(
            fmt::format("cannot write '{}': {}{}", path_.string(), reason(error), restored ? "; what was there before is unchanged" : ""));
    }
    for (const Row& row : rows) jobs_.insert(row["job"].get<std::string>());
}

}  // namespace gno::study
