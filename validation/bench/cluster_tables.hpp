// SPDX-License-Identifier: MIT
// The measurements of the 2014 paper on this project's cluster hierarchy, in Markdown on standard output.
#pragma once
#include <string>
#include <vector>

#include "host_min/techniques/technique.hpp"

namespace gno::bench {

struct ClusterJob {
    std::vector<std::string> scenes;
    uint32_t width = 1024, height = 1024, light = 0;
    uint32_t lastFrame = 56, frameStep = 4;
    host::Cull cull = host::Cull::front;  ///< as in the paper's figure 6
    host::Precision precision = host::Precision::certified;
    std::string csv;          ///< per-frame numbers go here; empty: nowhere
    bool defaults = false;    ///< product: the default settings only
    std::string keep, given;  ///< product: folder to write view samples to, to take them from instead of rasterising; empty: neither
};

/// Test-and-set operations and stage times along a path, by variant (figures 5, 6 and 8).
void printPaths(host::PassCache& passes, const ClusterJob& job);
/// Iterations of the jobs of one frame, one pass against two at every level (figure 7).
void printJobs(host::PassCache& passes, const ClusterJob& job);
/// One frame at 1280x720, 1024x1024 and 1920x1080: operations, stage times and bytes of each form of bounds (figure 9 and section 3).
void printSizes(host::PassCache& passes, const ClusterJob& job);
/// Against the TOP tree and the flat hierarchy, from few casters to many (light 0, one frame per scene).
void printAgainst(host::PassCache& passes, const ClusterJob& job);

/// The product of light, bounds, split and planes against the oracle; the number of wrong answers.
uint64_t printProduct(host::PassCache& passes, const ClusterJob& job);

}  // namespace gno::bench
