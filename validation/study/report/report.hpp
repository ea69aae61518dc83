// SPDX-License-Identifier: MIT
// gnomon-study report RESULTS.jsonl [--out FOLDER]: the page FOLDER/index.html and its charts FOLDER/*.png.
#pragma once
#include <filesystem>

namespace gno::report {

struct ReportOptions {
    std::filesystem::path results;
    std::filesystem::path out = "report";
};

/// Prints what was left out of the results, and where the page is. Throws InputError: no results in it, no display, a folder that cannot be written;
/// WorkError: anything else, such as a full disk. Each file is either complete or not there.
void report(const ReportOptions& options);

}  // namespace gno::report
