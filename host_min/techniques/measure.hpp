// SPDX-License-Identifier: MIT
// Device times that can be trusted: one warm-up (it holds the driver's compilation), then the median of some repeats.
#pragma once
#include <functional>
#include <vector>

#include "host_min/vulkan/recording.hpp"

namespace gno::host {

/// Per pass the median of its times; all runs have the same passes.
std::vector<PassTime> medianOf(const std::vector<std::vector<PassTime>>& runs);

/// Records and submits `record` once to warm up (when `warmUp`) and `repeat` times (>= 1); per pass the median time. The state after the last run
/// stays.
std::vector<PassTime> measure(const Device& device, uint32_t repeat, bool warmUp, const std::function<void(Recording&)>& record);

}  // namespace gno::host
