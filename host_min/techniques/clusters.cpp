// SPDX-License-Identifier: MIT
#include "host_min/techniques/clusters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "host_min/techniques/cluster_hierarchy.hpp"

namespace gno::host {
namespace {

constexpr size_t kLargestJobs = 1024;  // of figure 7

ClusterForm formByName(const std::string& word) {
    return word == "implicit" ? ClusterForm::implicitBounds : word == "explicit" ? ClusterForm::explicitBounds : ClusterForm::compact;
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

    std::string structureKey(const FrameInputs& inputs, const Settings& settings, const RunOptions& options) const override {
        const ClusterOptions o = optionsOf(inputs.hasMaterials(), settings, options);
        return fmt::format("clusters {} {} {} {} {} {} {}", uint32_t(o.form), o.split, o.extraPlanes, o.groups, o.jobCapacity, o.boxCapacity,
                           o.layers);
    }

    std::unique_ptr<Structure> makeStructure(const FrameInputs& inputs, const Settings& settings, const RunOptions& options) const override {
        return std::make_unique<ClusterHierarchy>(optionsOf(inputs.hasMaterials(), settings, options));
    }

    std::string overLimit(const DeviceFacts& device, const FrameLoad& load, const Settings& settings) const override {
        return clusterOverLimit(device, load, optionsOf(load.materials, settings, {}));
    }

    Query query(const Structure& structure, const FrameInputs& inputs, const Settings&, const RunOptions&) const override {
        const auto& hierarchy = dynamic_cast<const ClusterHierarchy&>(structure);
        return {clusterQueryPasses(inputs.width(), inputs.height(), hierarchy.options()), hierarchy.bindings(), false};
    }

    void read(const Structure& structure, const FrameInputs&, const Settings&, const RunOptions& options, TechniqueResult& result) const override {
        const auto& hierarchy = dynamic_cast<const ClusterHierarchy&>(structure);
        if (options.counters) count(hierarchy, result);
        result.bytes = hierarchy.bytes();
        if (hierarchy.options().layers) result.sums = hierarchy.sums();
        if (options.dump) result.dump = hierarchy.dump();
    }

private:
    ClusterOptions optionsOf(bool materials, const Settings& settings, const RunOptions& options) const {
        ClusterOptions choice;
        choice.precision = uint32_t(options.precision);
        choice.form = flat_ ? ClusterForm::flat : formByName(settings.word("bounds"));
        if (!flat_) choice.boxCapacity = settings.number("boxes");
        choice.split = settings.word("split") == "off" ? 0 : uint32_t(settings.word("split")[0] - '0');
        choice.jobCapacity = settings.number("jobs");
        choice.extraPlanes = settings.word("planes") == "extra";
        choice.groups = settings.number("groups");
        choice.layers = materials && settings.word("materials") == "on";
        return choice;
    }

    static void count(const ClusterHierarchy& hierarchy, TechniqueResult& result) {
        const ClusterCounters& counters = hierarchy.counters();
        const ClusterOptions& choice = hierarchy.options();
        result.sampleTests = counters.testsOfPixel;
        RecordCounters& totals = result.counters;
        totals.visitedNodes = counters.nodeTests;
        totals.exactCalls = counters.exactCalls;
        totals.testAndSet = counters.nodeTests + counters.leafTests;
        totals.stackOverflows = choice.split > 0 && counters.jobs > choice.jobCapacity ? counters.jobs - choice.jobCapacity : 0;
        totals.more = {{"node_tests", counters.nodeTests},         {"leaf_tests", counters.leafTests},
                       {"plane_tests", counters.planeTests},       {"accepted_nodes", counters.accepted},
                       {"occupied_nodes", counters.occupiedNodes}, {"tree_nodes", clusterNodeCount(hierarchy.layout())}};
        if (choice.form == ClusterForm::compact) {
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
