// SPDX-License-Identifier: MIT
// gnomon-study short and full: lists of sweeps, to be run from the project's root.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "validation/study/command.hpp"
#include "validation/study/sweep_options.hpp"

namespace gno::study {

enum class Preset { shortStudy, tiny, full };

/// Its sweeps. Keys that no technique of this build knows are left out; `leftOut` gets a line for each.
std::vector<SweepOptions> presetSweeps(Preset preset, std::vector<std::string>& leftOut);

/// What a study ends with: a page from its results file, in this folder.
using Finish = std::function<void(const std::filesystem::path& results, const std::filesystem::path& out)>;

void addShort(CLI::App& program, Action& chosen, const Finish& finish);
void addFull(CLI::App& program, Action& chosen, const Finish& finish);

}  // namespace gno::study
