// SPDX-License-Identifier: MIT
#include "validation/bench/tables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

namespace gno::bench {
namespace {

const std::vector<std::string> kQueries{"psv", "d-psv", "d-stackless", "d-hybrid"};

void flush() { std::fflush(stdout); }

}  // namespace

void printQueries(host::PassCache& passes, const Job& base, const std::vector<std::string>& scenes) {
    fmt::print(
        "| scene | casters | samples | technique | nodes/sample | ratio to psv | deepest stack | overflows | build ms | query ms | query/psv | "
        "bytes/caster |\n|{}\n",
        "---|---|---|---|---|---|---|---|---|---|---|---|");
    for (const std::string& scene : scenes) {
        Job job = base;
        job.scene = scene;
        job.techniques = kQueries;
        const Results results = run(passes, job).at(job.precisions.front());
        const Result& psv = results.at("psv");
        for (const std::string& name : kQueries) {
            const Result& r = results.at(name);
            fmt::print("| {} | {} of {} | {} | `{}` | {} | {} | {:.0f} | {:.0f} | {} | {} | {} | {:.1f} |\n", stem(scene), r.casters, r.triangles,
                       r.samples, name, r.nodes.text(1), ratio(r.nodesBySeed, psv.nodesBySeed).text(2), r.maxStack.mean, r.overflows.mean,
                       r.buildMs.text(0), r.queryMs.text(0), ratio(r.queryMsByRun, psv.queryMsByRun).text(2),
                       double(r.treeBytes) / double(r.triangles));
            flush();
        }
    }
}

void printLadder(host::PassCache& passes, const Job& base, const std::vector<std::string>& scenes) {
    using host::Precision;
    const auto rungs = [](const auto& value) {
        return fmt::format("{} / {} / {}", value(Precision::published), value(Precision::conservative), value(Precision::certified));
    };
    fmt::print(
        "| scene | light | casters | samples | psv wrong | psv nodes/sample | d-hybrid wrong | d-hybrid nodes/sample | decisions/sample | build | "
        "psv query | d-hybrid query | build and d-hybrid |\n|{}\n",
        "---|---|---|---|---|---|---|---|---|---|---|---|---|");
    for (const std::string& scene : scenes) {
        for (const uint32_t light : {0u, 1u}) {
            Job job = base;
            job.scene = scene;
            job.light = light;
            job.check = true;
            job.precisions = {Precision::published, Precision::conservative, Precision::certified};
            job.techniques = {"psv", "d-hybrid"};
            auto all = run(passes, job);
            const auto wrong = [&](const char* name) { return rungs([&](Precision p) { return fmt::format("{:.1f}", all[p][name].wrong.mean); }); };
            const auto nodes = [&](const char* name) { return rungs([&](Precision p) { return all[p][name].nodes.text(1); }); };
            const auto times = [&](const auto& milliseconds) {
                const auto part = [&](Precision p) { return medianRatio(milliseconds(all[p]), milliseconds(all[Precision::conservative])); };
                return fmt::format("{:.2f} / {:.2f}", part(Precision::published), part(Precision::certified));
            };
            const auto total = [](Results& r) {
                std::vector<double> sum = r["d-hybrid"].queryMsByRun;
                for (size_t i = 0; i < sum.size(); ++i) sum[i] += r["d-hybrid"].buildMsByRun[i];
                return sum;
            };
            const Result& any = all[Precision::certified]["psv"];
            fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", stem(scene), light, any.casters, any.samples,
                       wrong("psv"), nodes("psv"), wrong("d-hybrid"), nodes("d-hybrid"),
                       rungs([&](Precision p) { return fmt::format("{:.3f}", all[p]["d-hybrid"].exactCalls.mean); }),
                       times([](Results& r) { return r["psv"].buildMsByRun; }), times([](Results& r) { return r["psv"].queryMsByRun; }),
                       times([](Results& r) { return r["d-hybrid"].queryMsByRun; }), times(total));
            flush();
        }
    }
    fmt::print(
        "\nWrong: samples, mean over the insertion orders. Cells are published / conservative / certified; the last four hold times, published / "
        "certified, as median over {} runs of the\n"
        "ratio to conservative in the same run.\n",
        base.seeds * base.repeats);
}

void printStacks(host::PassCache& passes, const Job& base, const std::vector<std::string>& scenes) {
    const std::vector<uint32_t> sizes{4, 8, 12, 16, 20, 24, 32, 48};
    fmt::print("| scene | stack | nodes/sample | overflows | query ms | query/stack 12 |\n|---|---|---|---|---|---|\n");
    for (const std::string& scene : scenes) {
        std::map<uint32_t, Result> all;
        for (const uint32_t size : sizes) {
            Job job = base;
            job.scene = scene;
            job.techniques = {"d-hybrid"};
            job.settings = {fmt::format("stack={}", size)};
            all[size] = run(passes, job).at(job.precisions.front()).at("d-hybrid");
        }
        for (const uint32_t size : sizes) {
            const Result& r = all.at(size);
            fmt::print("| {} | {} | {} | {:.0f} | {} | {} |\n", stem(scene), size, r.nodes.text(1), r.overflows.mean, r.queryMs.text(0),
                       ratio(r.queryMsByRun, all.at(12).queryMsByRun).text(2));
        }
        flush();
    }
}

void printGrowth(host::PassCache& passes, const Job& base, const std::vector<std::string>& scenes) {
    fmt::print(
        "| scene | casters | build steps/caster | build ms | build exponent | psv nodes/sample | d-hybrid nodes/sample | d-hybrid exponent "
        "|\n|---|---|---|---|---|---|---|---|\n");
    std::optional<Result> before;
    for (const std::string& scene : scenes) {
        Job job = base;
        job.scene = scene;
        job.techniques = {"psv", "d-hybrid"};
        const Results results = run(passes, job).at(job.precisions.front());
        const Result& r = results.at("d-hybrid");
        const auto exponent = [&](double now, double then) {
            return before ? fmt::format("{:.2f}", std::log(now / then) / std::log(double(r.casters) / double(before->casters))) : std::string("-");
        };
        fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} |\n", stem(scene), r.casters, r.buildSteps.text(1), r.buildMs.text(0),
                   exponent(r.buildMs.mean, before ? before->buildMs.mean : 1), results.at("psv").nodes.text(1), r.nodes.text(1),
                   exponent(r.nodes.mean, before ? before->nodes.mean : 1));
        flush();
        before = r;
    }
}

}  // namespace gno::bench
