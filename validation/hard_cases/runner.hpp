// SPDX-License-Identifier: MIT
// Runs hard cases through the techniques of the registry that have a certified rung, on every rung they have, and compares with the oracle.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "validation/hard_cases/hard_case.hpp"

namespace gno::hard {

/// One technique on one rung, all scenes and insertion seeds of a case together.
struct Tally {
    std::string technique;
    host::Precision precision = host::Precision::certified;
    uint64_t runs = 0, answers = 0;  ///< answers: samples, summed over the runs
    uint64_t wrong = 0, leaks = 0, falseDark = 0;
    uint64_t visitedNodes = 0;  ///< summed over the answers; 0 without counters
    std::string firstWrong{};   ///< light, sample and caster as hex floats, and how it was run; empty when nothing is wrong
    std::string refused{};      ///< what the technique said when it could not run the case (InputError)
};

struct CaseResult {
    const HardCase* hardCase = nullptr;
    uint64_t triangles = 0, samples = 0, inShadow = 0;  ///< of all scenes of the case
    uint64_t bruteForced = 0;                           ///< samples that were also decided by brute force over 128-bit integers
    std::string oracleWrong;                            ///< the first sample where the oracle and brute force differ; empty: none
    std::vector<Tally> tallies;                         ///< techniques in the registry's order, rungs in the technique's
};

struct RunnerOptions {
    uint32_t insertionSeeds = 8;  ///< per case; shared out among its scenes, at least one each
    bool counters = false;        ///< count visited nodes (by the instrumented shaders) as well
    bool certifiedOnly = false;   ///< leave the other rungs out
    bool uncertified = false;     ///< run the techniques without a certified rung as well, to see how wrong they are
};

/// `step` is called before every run of a technique; it may throw to stop.
CaseResult runCase(const HardCase& hardCase, const RunnerOptions& options, const std::function<void()>& step = {});

}  // namespace gno::hard
