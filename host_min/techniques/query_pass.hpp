// SPDX-License-Identifier: MIT
// Asks a structure for every view sample, whatever the structure is: masks, per-pixel counts, the time.
#pragma once
#include "host_min/techniques/technique.hpp"

namespace gno::host {

/// Poisons and fills result.visibility, appends the timed passes, and with options.counters asks once more by the instrumented shader in the compute
/// stage: per-pixel counts and their totals (visited nodes, deepest stack, overflows, exact calls) go into `result`.
void ask(const FrameInputs& inputs, const Query& query, const RunOptions& options, TechniqueResult& result);

}  // namespace gno::host
