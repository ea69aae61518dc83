// SPDX-License-Identifier: MIT
// One group measured: each variant once with counters and the oracle's check, then all of them in turns, as often as asked.
#pragma once
#include <vector>

#include "validation/study/pictures.hpp"
#include "validation/study/results_file.hpp"
#include "validation/study/subject.hpp"

namespace gno::study {

/// Fills a row for each variant of `jobs`. What fails for want of a feature, of memory or of a limit of the device becomes a row with "unavailable";
/// anything else is thrown. `report` is told before every run and may throw to stop the work.
std::vector<Row> measureGroup(host::PassCache& passes, const host::SceneFile& file, const GroupJobs& jobs, const std::string& run, Worst& worst,
                              const std::filesystem::path& folder, const Report& report);

/// Runs that measureGroup will make, roughly: a search counts for its ladder.
uint64_t runsOf(const GroupJobs& jobs);

double median(std::vector<double> values);

}  // namespace gno::study
