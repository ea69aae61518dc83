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
    std::string scene;  ///< .glb file
    uint32_t width = 1920, height = 1080, frame = 0, light = 0;
    host::Cull cull = host::Cull::none;
    std::vector<host::Precision> precisions{host::Precision::certified};
    std::vector<std::string> techniques;  ///< those that share a structure share it
    std::vector<std::string> settings;    ///< without seed
    uint32_t seeds = 8;                   ///< 1 .. seeds
    uint32_t repeats = 1;                 ///< of each time; the precisions take turns, so that a busy machine is busy for all of them
    bool check = false;
};

/// One frame and light of a job, and the oracle's answers.
class Subject {
public:
    Subject(host::PassCache& passes, const Job& job, bool check);
    [[nodiscard]] const host::Frame& frame() const { return frame_; }
    [[nodiscard]] const host::FrameInputs& inputs() const { return inputs_; }
    /// Samples with another answer than the oracle's.
    [[nodiscard]] uint64_t wrong(const std::vector<uint32_t>& visibility) const;

private:
    host::Frame frame_;
    host::FrameInputs inputs_;
    std::vector<uint8_t> truth_;
};

struct Statistic {
    double mean = 0, deviation = 0;  ///< over the seeds; deviation of the sample
    std::string text(int digits) const;
};
Statistic statistic(const std::vector<double>& values);
/// Of a[i] / b[i]: the order of insertion, or the machine's other work, moves both.
Statistic ratio(const std::vector<double>& a, const std::vector<double>& b);
double medianRatio(const std::vector<double>& a, const std::vector<double>& b);
std::string stem(const std::string& scene);  ///< without folder and ending

struct Result {
    uint64_t casters = 0, samples = 0, treeBytes = 0, triangles = 0;
    Statistic nodes, buildMs, queryMs, exactCalls, wrong, overflows, maxStack, buildSteps;
    std::vector<double> nodesBySeed, queryMsByRun, buildMsByRun;  ///< a run: a repeat of a seed
};

using Results = std::map<std::string, Result>;  ///< by technique

/// Prints a line of progress to standard error when that is a terminal.
std::map<host::Precision, Results> run(host::PassCache& passes, const Job& job);

}  // namespace gno::bench
