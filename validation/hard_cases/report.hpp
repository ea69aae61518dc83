// SPDX-License-Identifier: MIT
// Results of hard cases as Markdown, and their place in a file.
#pragma once
#include <span>
#include <string>

#include "validation/hard_cases/runner.hpp"

namespace gno::hard {

/// Two tables, wrong answers and visited nodes per sample: a row per case, a column per technique, a number per rung of it.
[[nodiscard]] std::string markdown(std::span<const CaseResult> results, const RunnerOptions& options);

/// `text` with what stands between the lines `<!-- hard cases: begin -->` and `<!-- hard cases: end -->` replaced. Throws InputError when it lacks
/// them.
[[nodiscard]] std::string replaceSection(const std::string& text, const std::string& section);

}  // namespace gno::hard
