// SPDX-License-Identifier: MIT
// One measured combination, and statistics over seeds.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host_min/techniques/technique.hpp"

namespace gno::bench {

struct Job {
    std::string scene;                     ///< .glb file
    uint32_t width = 1920, height = 1080, frame = 0, light = 0;
    host::Cull cull = host::Cull::none;
    host::Precision precision = host::Precision::certified;
    std::vector<std::string> techniques;   ///< those that share a structure share it
    std::vector<std::string> settings;     ///< without seed
    uint32_t seeds = 8;                    ///< 1 .. seeds
    bool check = false;
};

struct Statistic {
    double mean = 0, deviation = 0;  ///< over the seeds; deviation of the sample
    std::string text(int digits) const;
};
Statistic statistic(const std::vector<double>& values);

struct Result {
    uint64_t casters = 0, samples = 0, treeBytes = 0, triangles = 0;
    Statistic nodes, buildMs, queryMs, exactCalls, wrong, overflows, maxStack, buildSteps;
    std::vector<double> nodesBySeed, queryMsBySeed, buildMsBySeed;
};

/// By technique. Prints a line of progress to standard error when that is a terminal.
std::map<std::string, Result> run(host::PassCache& passes, const Job& job);

}  // namespace gno::bench
