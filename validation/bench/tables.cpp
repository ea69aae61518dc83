// SPDX-License-Identifier: MIT
#include "validation/bench/tables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

namespace gno::bench {
namespace {

const std::vector<std::string> kQueries{"psv", "d-psv", "d-stackless", "d-hybrid"};

std::string stem(const std::string& scene) { return std::filesystem::path(scene).stem().string(); }

/// Mean and spread of a[i] / b[i]: seed by seed, because the order alone moves both.
Statistic ratio(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> values;
    for (size_t i = 0; i < a.size(); ++i) values.push_back(a[i] / b[i]);
    return statistic(values);
}

void flush() { std::fflush(stdout); }

}  // namespace

void printQueries(host::PassCache& passes, const Job& base, const std::vector<std::string>& scenes) {
    fmt::print("| scene | casters | samples | technique | nodes/sample | ratio to psv | deepest stack | overflows | build ms | query ms | query/psv | bytes/caster |\n|{}\n",
               "---|---|---|---|---|---|---|---|---|---|---|---|");
    for (const std::string& scene : scenes) {
        Job job = base;
        job.scene = scene;
        job.techniques = kQueries;
        const auto results = run(passes, job);
        const Result& psv = results.at("psv");
        for (const std::string& name : kQueries) {
            const Result& r = results.at(name);
            fmt::print("| {} | {} of {} | {} | `{}` | {} | {} | {:.0f} | {:.0f} | {} | {} | {} | {:.1f} |\n", stem(scene), r.casters, r.triangles, r.samples, name, r.nodes.text(1),
                       ratio(r.nodesBySeed, psv.nodesBySeed).text(2), r.maxStack.mean, r.overflows.mean, r.buildMs.text(0), r.queryMs.text(0),
                       ratio(r.queryMsBySeed, psv.queryMsBySeed).text(2), double(r.treeBytes) / double(r.triangles));
            flush();
        }
    }
}

void printLadder(host::PassCache& passes, const Job& base, const std::vector<std::string>& scenes) {
    fmt::print("| scene | light | technique | precision | wrong | nodes/sample | decisions/sample | build/conservative | query/conservative | total/conservative |\n|{}\n",
               "---|---|---|---|---|---|---|---|---|---|");
    for (const std::string& scene : scenes) {
        for (const uint32_t light : {0u, 1u}) {
            std::map<host::Precision, std::map<std::string, Result>> all;
            for (const auto precision : {host::Precision::conservative, host::Precision::published, host::Precision::certified}) {
                Job job = base;
                job.scene = scene;
                job.light = light;
                job.precision = precision;
                job.check = true;
                job.techniques = {"psv", "d-hybrid"};
                all[precision] = run(passes, job);
            }
            for (const char* name : {"psv", "d-hybrid"}) {
                const Result& reference = all.at(host::Precision::conservative).at(name);
                for (const auto& [precision, results] : all) {
                    const Result& r = results.at(name);
                    std::vector<double> total, referenceTotal;
                    for (size_t i = 0; i < r.buildMsBySeed.size(); ++i) {
                        total.push_back(r.buildMsBySeed[i] + r.queryMsBySeed[i]);
                        referenceTotal.push_back(reference.buildMsBySeed[i] + reference.queryMsBySeed[i]);
                    }
                    fmt::print("| {} | {} | `{}` | {} | {} of {} | {} | {:.3f} | {} | {} | {} |\n", stem(scene), light, name, host::name(precision), r.wrong.text(1), r.samples,
                               r.nodes.text(1), r.exactCalls.mean, ratio(r.buildMsBySeed, reference.buildMsBySeed).text(2), ratio(r.queryMsBySeed, reference.queryMsBySeed).text(2),
                               ratio(total, referenceTotal).text(2));
                    flush();
                }
            }
        }
    }
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
            all[size] = run(passes, job).at("d-hybrid");
        }
        for (const uint32_t size : sizes) {
            const Result& r = all.at(size);
            fmt::print("| {} | {} | {} | {:.0f} | {} | {} |\n", stem(scene), size, r.nodes.text(1), r.overflows.mean, r.queryMs.text(0), ratio(r.queryMsBySeed, all.at(12).queryMsBySeed).text(2));
        }
        flush();
    }
}

void printGrowth(host::PassCache& passes, const Job& base, const std::vector<std::string>& scenes) {
    fmt::print("| scene | casters | build steps/caster | build ms | build exponent | psv nodes/sample | d-hybrid nodes/sample | d-hybrid exponent |\n|---|---|---|---|---|---|---|---|\n");
    std::optional<Result> before;
    for (const std::string& scene : scenes) {
        Job job = base;
        job.scene = scene;
        job.techniques = {"psv", "d-hybrid"};
        const auto results = run(passes, job);
        const Result& r = results.at("d-hybrid");
        const auto exponent = [&](double now, double then) {
            return before ? fmt::format("{:.2f}", std::log(now / then) / std::log(double(r.casters) / double(before->casters))) : std::string("-");
        };
        fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} |\n", stem(scene), r.casters, r.buildSteps.text(1), r.buildMs.text(0), exponent(r.buildMs.mean, before ? before->buildMs.mean : 1),
                   results.at("psv").nodes.text(1), r.nodes.text(1), exponent(r.nodes.mean, before ? before->nodes.mean : 1));
        flush();
        before = r;
    }
}

}  // namespace gno::bench
