// SPDX-License-Identifier: MIT
#include "validation/bench/cluster_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ostream>

#include "host_min/error.hpp"
#include "host_min/output/atomic_file.hpp"
#include "host_min/output/table.hpp"
#include "validation/bench/run.hpp"

namespace gno::bench {
namespace {

struct Variant {
    std::string name, technique;
    std::vector<std::string> settings;
};

const std::vector<Variant> kVariants{
    {"2011", "ptsv-2011", {"split=off"}},
    {"implicit", "ptsv", {"bounds=implicit", "planes=own", "split=off"}},
    {"+ extra planes", "ptsv", {"bounds=implicit", "split=off"}},
    {"+ explicit bounds", "ptsv", {"bounds=compact", "split=off"}},
    {"+ two passes", "ptsv", {"bounds=compact", "split=2"}},
};

struct Numbers {
    double operations = 0, nodes = 0, leaves = 0, build = 0, setUp = 0, traverse = 0, merge = 0, total = 0, worstJob = 0, averageJob = 0;
    uint64_t bytes = 0;
    host::NamedNumbers more, arrays;
};

uint64_t find(const host::NamedNumbers& numbers, const std::string& name) {
    const auto at = std::find_if(numbers.begin(), numbers.end(), [&](const auto& entry) { return entry.first == name; });
    return at == numbers.end() ? 0 : at->second;
}

Numbers measureOne(const host::FrameInputs& inputs, const Variant& variant, host::Precision precision, uint32_t repeat) {
    host::Technique& technique = host::techniqueByName(variant.technique);
    host::StructureCache structures;
    const host::Settings settings(technique.info().settings, variant.settings);
    const host::TechniqueResult result = technique.run(inputs, structures, settings, {precision, repeat, true, false, true});
    Numbers n;
    n.operations = double(result.counters.testAndSet);
    n.nodes = double(find(result.counters.more, "node_tests"));
    n.leaves = double(find(result.counters.more, "leaf_tests"));
    for (const host::RecordPass& pass : result.passes) {
        n.total += pass.ms;
        if (pass.name == "cluster_build")
            n.build = pass.ms;
        else if (pass.name == "cluster_setup")
            n.setUp = pass.ms;
        else if (pass.name == "cluster_merge")
            n.merge = pass.ms;
        else if (pass.name != "caster_setup")
            n.traverse += pass.ms;
    }
    const std::string last = find(result.counters.more, "finish_jobs") > 0 ? "finish" : "expand";
    n.worstJob = double(std::max(find(result.counters.more, "expand_worst_job"), find(result.counters.more, "finish_worst_job")));
    n.averageJob = double(find(result.counters.more, last + "_steps")) / double(std::max<uint64_t>(1, find(result.counters.more, last + "_jobs")));
    for (const auto& [name, bytes] : result.bytes) n.bytes += bytes;
    n.more = result.counters.more;
    n.arrays = result.bytes;
    return n;
}

std::string millions(const std::vector<double>& values) {
    const Statistic s = statistic(values);
    return fmt::format("{:.2f} ({:.2f} to {:.2f})", s.mean / 1e6, *std::min_element(values.begin(), values.end()) / 1e6,
                       *std::max_element(values.begin(), values.end()) / 1e6);
}

/// Mean of a[i] / b[i], smallest and largest.
std::string ratios(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> values;
    for (size_t i = 0; i < a.size(); ++i) values.push_back(b[i] > 0 ? a[i] / b[i] : 0);
    return fmt::format("{:.2f} ({:.2f} to {:.2f})", statistic(values).mean, *std::min_element(values.begin(), values.end()),
                       *std::max_element(values.begin(), values.end()));
}

double meanOf(const std::vector<Numbers>& all, double Numbers::*member) {
    double sum = 0;
    for (const Numbers& n : all) sum += n.*member / double(all.size());
    return sum;
}

host::FrameInputs inputsOf(host::PassCache& passes, const host::Frame& frame, const ClusterJob& job, uint32_t width, uint32_t height) {
    host::FrameInputs inputs(passes, frame, width, height);
    if (job.light >= frame.lights.size()) throw host::InputError(fmt::format("--light {}: the scene has {}", job.light, frame.lights.size()));
    inputs.setLight(frame.lights[job.light].homogeneous, job.cull);
    return inputs;
}

}  // namespace

void printPaths(host::PassCache& passes, const ClusterJob& job) {
    std::string csv = "scene,frame,variant,test_and_set,node_tests,leaf_tests,build_ms,setup_ms,traverse_ms,merge_ms\n";
    fmt::print(
        "| scene | variant | operations, millions: mean (range) | to 2011 | node tests | sample tests | build ms | set-up ms | traverse ms | merge "
        "ms | worst job | worst/average |\n|{}\n",
        "---|---|---|---|---|---|---|---|---|---|---|---|");
    host::Progress progress;
    for (const std::string& scene : job.scenes) {
        const host::SceneFile file = host::SceneFile::load(scene);
        std::vector<std::vector<Numbers>> all(kVariants.size());
        for (uint32_t number = 0; number <= job.lastFrame; number += job.frameStep) {
            progress.show(scene, double(number) / (job.lastFrame + 1));
            const host::Frame frame = file.evaluate(number, 0);
            const host::FrameInputs inputs = inputsOf(passes, frame, job, job.width, job.height);
            for (size_t i = 0; i < kVariants.size(); ++i) {
                const Numbers n = measureOne(inputs, kVariants[i], job.precision, 1);
                all[i].push_back(n);
                csv += fmt::format("{},{},{},{},{},{},{:.3f},{:.3f},{:.3f},{:.3f}\n", stem(scene), number, kVariants[i].name, n.operations, n.nodes,
                                   n.leaves, n.build, n.setUp, n.traverse, n.merge);
            }
        }
        progress.clear();
        const auto list = [&](size_t i) {
            std::vector<double> values;
            for (const Numbers& n : all[i]) values.push_back(n.operations);
            return values;
        };
        for (size_t i = 0; i < kVariants.size(); ++i) {
            const auto mean = [&](double Numbers::*member) { return meanOf(all[i], member); };
            fmt::print("| {} | {} | {} | {} | {:.2f} | {:.2f} | {:.0f} | {:.0f} | {:.0f} | {:.0f} | {:.0f} | {:.1f} |\n", stem(scene),
                       kVariants[i].name, millions(list(i)), ratios(list(i), list(0)), mean(&Numbers::nodes) / 1e6, mean(&Numbers::leaves) / 1e6,
                       mean(&Numbers::build), mean(&Numbers::setUp), mean(&Numbers::traverse), mean(&Numbers::merge), mean(&Numbers::worstJob),
                       mean(&Numbers::worstJob) / mean(&Numbers::averageJob));
        }
        std::fflush(stdout);
    }
    if (job.csv.empty()) return;
    host::AtomicFile out(job.csv);
    out.stream() << csv;
    out.commit();
}

void printJobs(host::PassCache& passes, const ClusterJob& job) {
    fmt::print(
        "| scene | split | jobs of pass 1 | jobs of pass 2 | worst job | average job | 1,024 largest, average | worst/average | operations, "
        "millions "
        "| traverse ms |\n|{}\n",
        "---|---|---|---|---|---|---|---|---|---|");
    for (const std::string& scene : job.scenes) {
        const host::Frame frame = host::SceneFile::load(scene).evaluate(0, 0);
        const host::FrameInputs inputs = inputsOf(passes, frame, job, job.width, job.height);
        for (const char* split : {"off", "1", "2", "3", "4", "5"}) {
            const Numbers n = measureOne(inputs, {split, "ptsv", {std::string("split=") + split}}, job.precision, 3);
            const bool two = find(n.more, "finish_jobs") > 0;
            const std::string last = two ? "finish" : "expand";
            const uint64_t jobs = find(n.more, last + "_jobs");
            fmt::print("| {} | {} | {} | {} | {:.0f} | {:.1f} | {:.1f} | {:.1f} | {:.2f} | {:.0f} |\n", stem(scene), split,
                       find(n.more, "expand_jobs"), find(n.more, "finish_jobs"), n.worstJob, n.averageJob,
                       double(find(n.more, last + "_steps_of_1024_worst")) / double(std::clamp<uint64_t>(jobs, 1, 1024)), n.worstJob / n.averageJob,
                       n.operations / 1e6, n.traverse);
            std::fflush(stdout);
        }
    }
}

void printSizes(host::PassCache& passes, const ClusterJob& job) {
    fmt::print(
        "| scene | size | bounds | operations, millions | build ms | set-up ms | traverse ms | merge ms | nodes of the full tree | occupied | masks "
        "| bounds | pointers |\n|{}\n",
        "---|---|---|---|---|---|---|---|---|---|---|---|---|");
    const auto mb = [](uint64_t bytes) { return bytes ? fmt::format("{:.2f} MB", double(bytes) / 1e6) : std::string("-"); };
    for (const std::string& scene : job.scenes) {
        const host::Frame frame = host::SceneFile::load(scene).evaluate(0, 0);
        for (const auto& [width, height] : {std::pair(1280u, 720u), std::pair(1024u, 1024u), std::pair(1920u, 1080u)}) {
            const host::FrameInputs inputs = inputsOf(passes, frame, job, width, height);
            for (const char* form : {"implicit", "explicit", "compact"}) {
                try {
                    const Numbers n = measureOne(inputs, {form, "ptsv", {std::string("bounds=") + form}}, job.precision, 3);
                    const uint64_t boxes = form == std::string("compact") ? 24 * find(n.more, "boxes") : find(n.arrays, "bounds");
                    fmt::print("| {} | {}x{} | {} | {:.2f} | {:.0f} | {:.0f} | {:.0f} | {:.0f} | {} | {} | {} | {} | {} |\n", stem(scene), width,
                               height, form, n.operations / 1e6, n.build, n.setUp, n.traverse, n.merge, find(n.more, "tree_nodes"),
                               find(n.more, "occupied_nodes"), mb(find(n.arrays, "masks")), mb(boxes), mb(find(n.arrays, "pointers")));
                } catch (const host::InputError&) {
                    fmt::print("| {} | {}x{} | {} | does not fit a binding |\n", stem(scene), width, height, form);
                }
                std::fflush(stdout);
            }
        }
    }
}

void printAgainst(host::PassCache& passes, const ClusterJob& job) {
    fmt::print(
        "| scene | casters | samples | d-hybrid ms | ptsv ms | ptsv-2011 ms | ptsv/d-hybrid | operations per sample | d-hybrid nodes per sample "
        "|\n|{}\n",
        "---|---|---|---|---|---|---|---|---|");
    for (const std::string& scene : job.scenes) {
        const host::Frame frame = host::SceneFile::load(scene).evaluate(0, 0);
        const host::FrameInputs inputs = inputsOf(passes, frame, job, job.width, job.height);
        const Numbers flat = measureOne(inputs, {"", "ptsv-2011", {}}, job.precision, 3);
        const Numbers clusters = measureOne(inputs, {"", "ptsv", {}}, job.precision, 3);
        host::StructureCache structures;
        host::Technique& hybrid = host::techniqueByName("d-hybrid");
        const host::TechniqueResult top = hybrid.run(inputs, structures, host::Settings(hybrid.info().settings, std::vector<std::string>()),
                                                     {job.precision, 3, true, false, true});
        double topMs = 0;
        for (const host::RecordPass& pass : top.passes) topMs += pass.ms;
        const double samples = double(std::max<uint64_t>(1, inputs.sampleCount()));
        fmt::print("| {} | {} | {} | {:.0f} | {:.0f} | {:.0f} | {:.2f} | {:.1f} | {:.1f} |\n", stem(scene), inputs.casterCount(),
                   inputs.sampleCount(), topMs, clusters.total, flat.total, clusters.total / topMs, clusters.operations / samples,
                   double(top.counters.visitedNodes) / samples);
        std::fflush(stdout);
    }
}

}  // namespace gno::bench
