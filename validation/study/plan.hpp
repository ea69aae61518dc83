// SPDX-License-Identifier: MIT
// gnomon-study plan: a sweep as independent jobs, one command line each. A job is a group with all its variants, so that ratios of times stay inside
// it.
#pragma once
#include "validation/study/command.hpp"

namespace gno::study {

/// `self`: how the program was called; the first word of each line.
void addPlan(CLI::App& program, Action& chosen, const std::string& self);

}  // namespace gno::study
