// SPDX-License-Identifier: MIT
// gnomon-study short and full: lists of sweeps, to be run from the project's root.
#pragma once
#include <string>
#include <vector>

#include "validation/study/command.hpp"
#include "validation/study/sweep_options.hpp"

namespace gno::study {

enum class Preset { shortStudy, tiny, full };

/// Its sweeps. Keys that no technique of this build knows are left out; `leftOut` gets a line for each.
std::vector<SweepOptions> presetSweeps(Preset preset, std::vector<std::string>& leftOut);

void addShort(CLI::App& program, Action& chosen);
void addFull(CLI::App& program, Action& chosen);

}  // namespace gno::study
