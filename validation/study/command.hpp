// SPDX-License-Identifier: MIT
// How a subcommand gets into the program: a function that adds it to the command line and says what to run when it was chosen.
#pragma once
#include <functional>

#include <CLI/CLI.hpp>

namespace gno::study {

/// What the chosen subcommand does; returns the exit code.
using Action = std::function<int()>;

}  // namespace gno::study
