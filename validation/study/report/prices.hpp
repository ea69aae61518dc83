// SPDX-License-Identifier: MIT
// "For this scene and this error you pay this", and what the numbers say in sentences.
#pragma once
#include <array>

#include "validation/study/report/study.hpp"

namespace gno::report {

inline constexpr std::array kThresholds{0.0, 1.0, 10.0, 100.0, 1000.0, 10000.0};  ///< wrong samples per million

struct Price {
    double threshold = 0;
    const Variant* cheapest = nullptr;   ///< no peer; nullptr: nothing is that right
    std::vector<const Variant*> asGood;  ///< others within the threshold whose times cannot be told from the cheapest one's
};

/// One a threshold.
std::vector<Price> pricesOf(const Setup& setup);

/// Sentences, most telling first; all numbers are computed from the rows.
std::vector<std::string> findingsOf(const Study& study);

/// The first few, and how many more.
std::string namesOf(const std::vector<const Variant*>& variants);
/// 1.31x (1.25..1.40)
std::string times(const Spread& spread);
/// 3100 ppm, or "none" of nothing wrong
std::string perMillion(double wrong);

}  // namespace gno::report
