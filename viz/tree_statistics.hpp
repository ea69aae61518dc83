// SPDX-License-Identifier: MIT
// Numbers about a TOP tree: depths, kinds of links, wedges, visits.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "viz/top_tree.hpp"

namespace gno::viz {

struct Histogram {
    std::string name, unit;
    std::vector<double> edges;  ///< one more than counts
    std::vector<uint64_t> counts;
};

struct TreeStatistics {
    uint64_t casters = 0, volumes = 0;
    uint64_t lateralPositive = 0, capPositive = 0, intersection = 0;  ///< links
    uint64_t visits = 0, samples = 0;
    uint64_t wedgesWithoutBound = 0;
    double meanDepth = 0;
    uint32_t deepest = 0;
    std::vector<uint64_t> volumesAtDepth, visitsAtDepth;  ///< by volumes above
    Histogram wedges;                                     ///< of intersection children; a light at a point: degrees; at infinity: metres
    Histogram visitsOfNodes;                              ///< powers of two

    [[nodiscard]] double intersectionShare() const;  ///< of all links to volumes; 0 without any
    [[nodiscard]] nlohmann::ordered_json json() const;
};

TreeStatistics statisticsOf(const Dump& dump, const TopTree& tree);

}  // namespace gno::viz
