// SPDX-License-Identifier: MIT
// gnomon-study merge: results files of several jobs, or machines, joined.
#pragma once
#include <filesystem>
#include <span>

#include "validation/study/command.hpp"
#include "validation/study/results_file.hpp"

namespace gno::study {

struct Merged {
    size_t rows = 0, twice = 0, pictures = 0;
    std::vector<std::string> notes;  ///< what is broken or missing, one line each
};

/// Rows of `into` come first when it is there; a job is taken once, the first time it was measured. Pictures are copied beside `into`, which is
/// replaced as a whole. Throws InputError or WorkError.
Merged mergeResults(std::span<const std::filesystem::path> files, const std::filesystem::path& into);

void addMerge(CLI::App& program, Action& chosen);

}  // namespace gno::study
