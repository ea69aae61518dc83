// SPDX-License-Identifier: MIT
// Heat maps of per-pixel counters (visited nodes, stack use, tests), with a legend that tells the numbers.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "host_min/output/image.hpp"

namespace gno::host {

struct HeatMapOptions {
    std::string title;                ///< "d-psv, certified: visited nodes"
    std::string unit;                 ///< what one is: "nodes"
    std::optional<uint32_t> maximum;  ///< value of the hottest colour, to compare pictures; default: the 99.9th percentile
};

struct HeatMapScale {
    uint32_t maximum = 0;  ///< largest valid value
    double mean = 0;       ///< of the valid values; 0 when there is none
    uint32_t hottest = 1;  ///< value from which on the hottest colour is used, at least 1
    uint64_t clamped = 0;  ///< valid values above `hottest`
};

/// `valid` is empty (all are) or holds one flag a pixel; 0: the pixel is in no statistics and is drawn dark grey.
[[nodiscard]] HeatMapScale heatMapScale(const Raster<uint32_t>& values, std::span<const uint8_t> valid, const HeatMapOptions& options);

/// Colour of t in [0, 1] (clamped), from cold to hot.
[[nodiscard]] glm::u8vec3 heatColor(double t);

/// The map with a legend below it: title, colour bar with ticks, mean and true maximum. As wide as `values`, but at least 320 pixels.
[[nodiscard]] Picture heatMap(const Raster<uint32_t>& values, std::span<const uint8_t> valid, const HeatMapOptions& options);

}  // namespace gno::host
