// SPDX-License-Identifier: MIT
// gnomon-study sweep: groups of jobs, one after the other, into a results file.
#pragma once
#include <filesystem>
#include <vector>

#include "validation/study/command.hpp"
#include "validation/study/job.hpp"
#include "validation/study/scenes.hpp"

namespace gno::study {

void addSweep(CLI::App& program, Action& chosen);

/// Measures what `results` does not hold yet, group by group; each group's rows are on the disk before the next one begins. Prints one line at the
/// end. Throws InputError, or WorkError: also for Ctrl-C, after which the same call goes on.
void runSweep(const std::vector<GroupJobs>& groups, SceneShelf& shelf, const std::filesystem::path& results);

/// Where the generated scenes of a results file lie.
std::filesystem::path sceneFolder(const std::filesystem::path& results);

}  // namespace gno::study
