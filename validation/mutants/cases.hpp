// SPDX-License-Identifier: MIT
// Families of tiny scenes, each hard for a TOP tree in one way that it is named after. Seeded: the same scenes in every run.
#pragma once
#include <string>
#include <vector>

#include "validation/support/top_on_cpu_check.hpp"

namespace gno::mutants {

enum class Check {
    tree,          ///< certified: all four queries agree with the definition
    decision,      ///< certified, without a tree: the last word on the first caster and each sample agrees with the definition
    conservative,  ///< the conservative tree's queries agree with the definition, where the samples are made so that they must
    nothingLost,   ///< conservative: what one caster alone shadows, by the definition and by its own tree, it shadows among the others, too
};

struct Case {
    std::string name;
    Check check = Check::tree;
    std::vector<cpu::TinyScene> scenes;
    std::vector<std::vector<uint8_t>> expected;  ///< per scene, by the definition; nothingLost: per caster and sample, this caster alone
};

/// All of them, cheap ones first.
std::vector<Case> makeCases();

/// The definition's answer for each caster alone and each sample.
std::vector<uint8_t> oneByOne(const cpu::TinyScene& scene);

/// Empty when the variant passes the first `scenes` of them; else one line: which scene, which query, what is wrong. Then the scene.
std::string failure(const Case& c, cpu::TopTree& tree, size_t scenes = SIZE_MAX);

}  // namespace gno::mutants
