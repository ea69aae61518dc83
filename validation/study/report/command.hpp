// SPDX-License-Identifier: MIT
// gnomon-study report: the subcommand.
#pragma once
#include "validation/study/command.hpp"

namespace gno::study {

void addReport(CLI::App& program, Action& chosen);

}  // namespace gno::study
