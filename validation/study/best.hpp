// SPDX-License-Identifier: MIT
// The value of one setting that leaves the fewest wrong samples.
#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "host_min/techniques/settings.hpp"

namespace gno::study {

/// Tries every word of a setting with choices. A number: a ladder over its whole range, in equal ratios where that spans more than two decades (0 is
/// a rung of its own), in equal steps otherwise; then finer ladders between the neighbours of the best rung, until a step changes nothing any more.
/// The default is always tried. Ties: the default, then the lesser value. `wrong` gives the wrong samples of a value and may throw.
std::string bestValue(const host::SettingInfo& info, const std::function<uint64_t(const std::string&)>& wrong);

}  // namespace gno::study
