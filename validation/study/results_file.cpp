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

bool isRow(const Row& row) {
    const auto isText = [&](const char* key) { return row.contains(key) && row[key].is_string(); };
    return row.is_object() && row.contains("schema") && row["schema"] == kResultsSchema && isText("kind") && row["kind"] == kResultsKind &&
           isText("job");
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

std::string lineOf(const Row& row) { return row.dump(-1, ' ', false, Row::error_handler_t::replace) + "\n"; }

ReadResults readResults(const fs::path& path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) throw host::InputError(fmt::format("cannot read '{}': it is a folder", path.string()));
    std::ifstream file(path, std::ios::binary);
    std::stringstream stream;
    if (!file || (stream << file.rdbuf(), file.bad())) throw host::InputError(fmt::format("cannot read '{}': {}", path.string(), reason(errno)));
    const std::string text = stream.str();
    ReadResults results;
    uint64_t number = 0, broken = 0;
    for (size_t begin = 0; begin < text.size();) {
        const size_t end = text.find('\n', begin), next = end == std::string::npos ? text.size() : end + 1;
        const std::string_view line = std::string_view(text).substr(begin, (end == std::string::npos ? text.size() : end) - begin);
        ++number;
        Row row = Row::parse(line, nullptr, false);
        if (isRow(row)) {
            results.rows.push_back(std::move(row));
            results.goodBytes = next;
            results.endsOpen = end == std::string::npos;
        } else if (next == text.size()) {
            results.brokenEnd = text.substr(begin);
            ++broken;
            results.notes.push_back(fmt::format("{}: the last line ({}) is broken", path.string(), number));
        } else {
            results.goodBytes = next;
            if (line.empty()) {
                begin = next;
                continue;
            }
            ++broken;
            results.notes.push_back(fmt::format("{}: line {} is no row of a study; skipped", path.string(), number));
        }
        begin = next;
    }
    if (results.rows.empty() && (broken > 1 || (broken == 1 && results.brokenEnd.find(kResultsKind) == std::string::npos)))
        throw host::InputError(fmt::format("'{}' holds no row of a study: name another file", path.string()));
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
        if (!read.brokenEnd.empty()) {
            const fs::path aside = path.string() + ".broken";
            std::ofstream kept(aside, std::ios::binary | std::ios::app);
            kept << read.brokenEnd << (read.brokenEnd.ends_with('\n') ? "" : "\n");
            kept.close();
            if (!kept) throw host::WorkError(fmt::format("cannot write '{}'", aside.string()));
            if (::ftruncate(file_, off_t(read.goodBytes)) != 0)
                throw host::WorkError(fmt::format("cannot write '{}': {}", path.string(), reason(errno)));
            read.notes.back() += fmt::format("; moved to {}", aside.string());
        }
        if (read.endsOpen)
            if (const int error = writeAll(file_, "\n")) throw host::WorkError(fmt::format("cannot write '{}': {}", path.string(), reason(error)));
        rows_ = std::move(read.rows);
        notes_ = std::move(read.notes);
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
