// SPDX-License-Identifier: MIT
// gnomon-study report: the subcommand.
#pragma once
#include <filesystem>

#include "validation/study/command.hpp"

namespace gno::study {

void addReport(CLI::App& program, Action& chosen);

/// The page of a study that has just been measured; in a build without VTK a line that says how to get it.
void finishStudy(const std::filesystem::path& results, const std::filesystem::path& out);

}  // namespace gno::study
