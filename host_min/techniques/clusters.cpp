// SPDX-License-Identifier: MIT
#include "host_min/techniques/clusters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "host_min/error.hpp"
#include "host_min/techniques/cluster_hierarchy.hpp"
#include "host_min/techniques/measure.hpp"

namespace gno::host {
namespace {

constexpr uint32_t kPoison = 0xDEADBEEFu;  // a shader that writes nothing must not look right
constexpr size_t kLargestJobs = 1024;      // of figure 7

uint32_t formByName(const std::string& word) {
    return word == "implicit" ? GNO_CLUSTER_IMPLICIT : word == "explicit" ? GNO_CLUSTER_EXPLICIT : GNO_CLUSTER_COMPACT;
}

/// Iterations of the jobs of one pass: the average, the largest, and the average of the 1,024 largest.
void addSteps(NamedNumbers& numbers, const std::string& pass, std::vector<uint32_t> steps) {
    const uint64_t jobs = uint64_t(std::count_if(steps.begin(), steps.end(), [](uint32_t s) { return s > 0; }));
    numbers.push_back({pass + "_steps", std::accumulate(steps.begin(), steps.end(), uint64_t(0))});
    numbers.push_back({pass + "_jobs", jobs});
    const size_t largest = std::min(kLargestJobs, steps.size());
    std::partial_sort(steps.begin(), steps.begin() + ptrdiff_t(largest), steps.end(), std::greater<>());
    numbers.push_back({pass + "_worst_job", steps.empty() ? 0 : steps.front()});
    numbers.push_back({pass + "_steps_of_1024_worst", std::accumulate(steps.begin(), steps.begin() + ptrdiff_t(largest), uint64_t(0))});
}

class ClusterTechnique final : public Technique {
public:
    explicit ClusterTechnique(bool flat) : flat_(flat) {
        info_.name = flat ? "ptsv-2011" : "ptsv";
        info_.paper = flat ? "Per-triangle shadow volumes, SIGGRAPH Asia 2011 (two-dimensional hierarchy)"
                           : "Per-Triangle Shadow Volumes Using a View-Sample Cluster Hierarchy, I3D 2014";
        info_.precisions = {Precision::published, Precision::conservative, Precision::certified};
        info_.effects = {"point_light", "directional_light", "spot_light", "open_casters", "alpha_tested_casters", "coloured_casters"};
        info_.subgroupBallot = true;
        if (!flat) {
            info_.settings.push_back({"bounds",
                                      "of a node: by its key; a box for every node of the full tree; boxes of existing nodes",
                                      0,
                                      0,
                                      {"implicit", "explicit", "compact"},
                                      "compact"});
            info_.settings.push_back(
                {"boxes", "entries of the list of boxes (compact); too few: some nodes fall back to implicit bounds", 1, 8388608, {}, "524288"});
        }
        info_.settings.push_back(
            {"split", "depth at which the first pass leaves jobs for the second; off: one pass", 0, 0, {"off", "1", "2", "3", "4", "5", "6"}, "2"});
        info_.settings.push_back({"jobs", "entries of the job list; a job that finds it full is finished in place", 0, 16777216, {}, "1048576"});
        info_.settings.push_back({"planes",
                                  flat ? "cull by the volume's own planes, or by two silhouette edges as well"
                                       : "cull by the volume's own planes, or by three extra ones as well",
                                  0,
                                  0,
                                  {"own", "extra"},
                                  "extra"});
        info_.settings.push_back(
            {"materials", "what alpha-tested and coloured casters let through; off: they cast as opaque ones", 0, 0, {"on", "off"}, "on"});
        info_.settings.push_back({"groups", "work groups of the traversal", 1, 65535, {}, "64"});
    }

    const TechniqueInfo& info() const override { return info_; }

    TechniqueResult run(const FrameInputs& inputs, StructureCache&, const Settings& settings, const RunOptions& options) override {
        const std::string missing = missingFor(info_, inputs.device().facts());
        if (!missing.empty()) throw InputError(fmt::format("technique {}: the device lacks {}", info_.name, missing));
        ClusterOptions choice;
        choice.precision = options.precision;
        choice.form = flat_ ? GNO_CLUSTER_FLAT : formByName(settings.word("bounds"));
        if (!flat_) choice.boxCapacity = settings.number("boxes");
        choice.split = settings.word("split") == "off" ? 0 : uint32_t(settings.word("split")[0] - '0');
        choice.jobCapacity = settings.number("jobs");
        choice.extraPlanes = settings.word("planes") == "extra";
        choice.groups = settings.number("groups");
        choice.layers = inputs.hasMaterials() && settings.word("materials") == "on";
        ClusterHierarchy hierarchy(inputs, choice);

        Image visibility(inputs.device(), inputs.width(), inputs.height(), vk::Format::eR32Uint);
        const auto poison = [&] { visibility.clear(vk::ClearColorValue(kPoison, kPoison, kPoison, kPoison)); };
        poison();
        TechniqueResult result;
        if (options.counters) count(hierarchy.count(visibility), hierarchy.layout(), choice, result);
        poison();
        result.passes.push_back({inputs.casterSetUp().name, inputs.casterSetUp().ms});
        for (const PassTime& pass : measure(inputs.device(), options.repeat, options.warmUp, [&](Recording& r) { hierarchy.record(r, visibility); }))
            result.passes.push_back({pass.name, pass.ms});
        result.bytes = hierarchy.bytes();
        result.visibility = visibility.downloadAs<uint32_t>();
        if (choice.layers) result.sums = hierarchy.sums();
        if (options.dump) result.dump = hierarchy.dump();
        return result;
    }

private:
    static void count(const ClusterCounters& counters, const GnoClusterLayout& layout, const ClusterOptions& choice, TechniqueResult& result) {
        result.sampleTests = counters.testsOfPixel;
        RecordCounters& totals = result.counters;
        totals.visitedNodes = counters.nodeTests;
        totals.exactCalls = counters.exactCalls;
        totals.testAndSet = counters.nodeTests + counters.leafTests;
        totals.stackOverflows = choice.split > 0 && counters.jobs > choice.jobCapacity ? counters.jobs - choice.jobCapacity : 0;
        totals.more = {{"node_tests", counters.nodeTests},         {"leaf_tests", counters.leafTests},
                       {"plane_tests", counters.planeTests},       {"accepted_nodes", counters.accepted},
                       {"occupied_nodes", counters.occupiedNodes}, {"tree_nodes", gnoClusterNodeCount(layout)}};
        if (choice.form == GNO_CLUSTER_COMPACT) {
            totals.more.push_back({"boxes", counters.boxes});
            totals.more.push_back({"boxes_missing", counters.boxes > choice.boxCapacity ? counters.boxes - choice.boxCapacity : 0});
        }
        if (choice.split > 0) totals.more.push_back({"jobs_left", std::min(counters.jobs, choice.jobCapacity)});
        addSteps(totals.more, "expand", counters.expandSteps);
        if (choice.split > 0) addSteps(totals.more, "finish", counters.finishSteps);
    }

    bool flat_;
    TechniqueInfo info_;
};

}  // namespace

std::unique_ptr<Technique> makeClusterTechnique(bool flat) { return std::make_unique<ClusterTechnique>(flat); }

}  // namespace gno::host
