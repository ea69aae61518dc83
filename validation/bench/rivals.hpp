// SPDX-License-Identifier: MIT
// Techniques with settings, and Embree, on the same view samples: what a sample costs, lit and shadowed apart, and the time of each as a ratio to
// the first.
#pragma once
#include <string>
#include <vector>

#include "host_min/techniques/technique.hpp"
#include "validation/bench/run.hpp"

namespace gno::bench {

/// One of those that are compared: NAME, NAME:KEY=VALUE:KEY=VALUE, or embree:fp32, embree:robust.
struct Contestant {
    std::string label;
    std::string name;                   ///< of the technique or the peer
    std::vector<std::string> settings;  ///< KEY=VALUE; of a peer: its precision alone
    bool peer = false;
};
Contestant contestant(const std::string& text);  ///< throws InputError

struct RivalJob {
    Job base;  ///< scene, light, culling, seeds, repeats, check
    std::vector<Contestant> contestants;
    std::vector<std::pair<uint32_t, uint32_t>> sizes;
    std::vector<std::string> scenes;
};

struct Cost {
    Statistic lit, shadowed, all;  ///< visited nodes (list items, where there are lists) per sample, over the seeds
    Statistic worst;               ///< of any sample
    Statistic tileWorst;           ///< mean over the 8x8 tiles of the worst sample in each
    std::vector<double> allBySeed;
    double bytes = 0, bytesPerCaster = 0;
    std::vector<double> buildMs, queryMs;  ///< by round
    uint64_t wrong = 0;                    ///< over all seeds
    std::string pairsPerCaster;            ///< of a forest or a grid; else empty
};

/// A Markdown table per size, a row per scene and contestant, and geometric means over the scenes. Contestants take turns, so that a busy machine is
/// busy for all of them. Returns how many samples were answered wrong.
uint64_t printRivals(host::PassCache& passes, const RivalJob& job);

}  // namespace gno::bench
