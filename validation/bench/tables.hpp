// SPDX-License-Identifier: MIT
// The tables of gnomon-bench, in Markdown on standard output.
#pragma once
#include <string>
#include <vector>

#include "validation/bench/run.hpp"

namespace gno::bench {

/// Visited nodes of the four queries and their ratio to psv, per seed; build and query time; bytes per caster (paper: figure 8, section 4.1).
void printQueries(host::PassCache& passes, const Job& base, const std::vector<std::string>& scenes);
/// published, conservative and certified, lights 0 and 1: wrong samples, visited nodes, exact calls, times as ratios to conservative.
void printLadder(host::PassCache& passes, const Job& base, const std::vector<std::string>& scenes);
/// d-hybrid with stacks of 4 to 48 entries (paper: figure 9).
void printStacks(host::PassCache& passes, const Job& base, const std::vector<std::string>& scenes);
/// Scenes of one family in growing size: build steps and time, visited nodes, with exponents between neighbours.
void printGrowth(host::PassCache& passes, const Job& base, const std::vector<std::string>& scenes);
/// What each improvement of the certified rung's routing is worth: the tree without it (variants/), and without all of them.
void printRouting(host::PassCache& passes, const Job& base, const std::vector<std::string>& scenes);
/// Exact calls with the samples' own casters and without (GNO_NO_CASTER), and where they come from.
void printOwn(host::PassCache& passes, const Job& base, const std::vector<std::string>& scenes);

}  // namespace gno::bench
