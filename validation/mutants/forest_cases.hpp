// SPDX-License-Identifier: MIT
// What the forest is asked on the CPU: families of casters and cells, each hard in one way that it is named after, and tiny scenes. Seeded: the same
// in every run.
#pragma once
#include "validation/support/forest_on_cpu_check.hpp"

namespace gno::mutants {

struct CellFamily {
    std::string name;
    std::vector<cpu::CellQuestion> questions;
};

std::vector<CellFamily> makeCellFamilies(uint questions);

struct ForestCase {
    std::string name;
    std::vector<cpu::TinyScene> scenes;
    std::vector<std::vector<uint8_t>> expected;  ///< by the definition
};

/// Scenes of the TOP tree's own cases (cases.hpp), at most `scenes` of each, and the forest's.
std::vector<ForestCase> makeForestCases(size_t scenes);

/// Empty when the variant holds all claims on the first `questions` of the family; else one line and the question.
std::string failure(const CellFamily& family, const cpu::Forest& forest, cpu::CellTally& tally, size_t questions = SIZE_MAX);

/// Empty when the variant's forests are right on the first `scenes`; else one line and the scene. Resolutions, view culling, covering and float
/// modes take turns.
std::string failure(const ForestCase& c, cpu::Forest& forest, size_t scenes = SIZE_MAX);

}  // namespace gno::mutants
