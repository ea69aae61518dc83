// SPDX-License-Identifier: MIT
// The tables of gnomon-bench that compare the modules with variants of their text.
#include <fmt/format.h>

#include <cstdio>
#include <numeric>

#include "host_min/output/table.hpp"
#include "validation/bench/tables.hpp"
#include "validation/bench/variant.hpp"

namespace gno::bench {
namespace {

using Names = std::vector<std::string>;
const Names kQueries{"psv", "d-stackless", "d-hybrid"};
const Names kRouting{kAsShipped, "no_touching", "one_sided_wedge", "no_substitutes", "intersection_at_caps", "all_off"};

/// Variants are made when they are first needed: the driver compiles each.
class Variants {
public:
    explicit Variants(const host::Device& device) : device_(device) {}
    const Variant& get(const std::string& name) {
        auto& variant = variants_[name];
        if (!variant) variant = std::make_unique<Variant>(device_, name);
        return *variant;
    }

private:
    const host::Device& device_;
    std::map<std::string, std::unique_ptr<Variant>> variants_;
};

double mean(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size()); }

struct Tally {
    std::map<std::string, std::vector<double>> nodes, exact;  ///< by technique, per sample; an entry per seed
    std::vector<double> steps;                                ///< per caster
    uint64_t wrong = 0;                                       ///< over all techniques and seeds
};

Tally tally(const Variant& variant, const Names& queries, const Subject& subject, const host::FrameInputs& inputs, uint32_t seeds,
            host::Progress& progress, const std::string& what) {
    Tally result;
    const double samples = double(std::max<uint64_t>(inputs.sampleCount(), 1));
    for (uint32_t seed = 1; seed <= seeds; ++seed) {
        progress.show(what, double(seed - 1) / seeds);
        const Variant::Tree tree = variant.build(inputs, seed);
        result.steps.push_back(double(tree.steps) / double(std::max<uint64_t>(inputs.casterCount(), 1)));
        for (const std::string& name : queries) {
            const Variant::Answer answer = variant.ask(inputs, tree, name);
            result.nodes[name].push_back(double(answer.visitedNodes) / samples);
            result.exact[name].push_back(double(answer.exactCalls) / samples);
            result.wrong += subject.wrong(answer.visibility);
        }
    }
    return result;
}

}  // namespace

void printRouting(host::PassCache& passes, const Job& base, const std::vector<std::string>& scenes) {
    fmt::print(
        "| scene | light | routing | psv nodes/sample | ratio | d-stackless nodes/sample | ratio | d-hybrid nodes/sample | ratio | build "
        "steps/caster | ratio | d-hybrid exact calls/sample "
        "| wrong |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    Variants variants(passes.device());
    host::Progress progress;
    for (const std::string& scene : scenes) {
        for (const uint32_t light : {0u, 1u}) {
            Job job = base;
            job.scene = scene;
            job.light = light;
            const Subject subject(passes, job, true);
            Tally shipped;
            for (const std::string& name : kRouting) {
                const Tally t =
                    tally(variants.get(name), kQueries, subject, subject.inputs(), base.seeds, progress, fmt::format("{} {}", scene, name));
                if (name == kAsShipped) shipped = t;
                std::string cells;
                for (const std::string& query : kQueries)
                    cells +=
                        fmt::format("{} | {} | ", statistic(t.nodes.at(query)).text(1), ratio(t.nodes.at(query), shipped.nodes.at(query)).text(2));
                progress.clear();
                fmt::print("| {} | {} | {} | {}{} | {} | {:.4f} | {} |\n", stem(scene), light, name, cells, statistic(t.steps).text(1),
                           ratio(t.steps, shipped.steps).text(2), mean(t.exact.at("d-hybrid")), t.wrong);
                std::fflush(stdout);
            }
        }
    }
    fmt::print("\nRatio: to the same insertion order as shipped. Wrong: samples, over all three queries and all orders.\n");
}

void printOwn(host::PassCache& passes, const Job& base, const std::vector<std::string>& scenes) {
    fmt::print(
        "| scene | light | samples | own | psv nodes/sample | d-hybrid nodes/sample | psv exact calls/sample | d-hybrid exact calls/sample | of "
        "these at caps | at caps beside own | integers/sample "
        "| wrong |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    Variants variants(passes.device());
    host::Progress progress;
    for (const std::string& scene : scenes) {
        for (const uint32_t light : {0u, 1u}) {
            Job job = base;
            job.scene = scene;
            job.light = light;
            const Subject subject(passes, job, true);
            for (const bool skipped : {true, false}) {
                std::vector<host::OracleSample> samples = subject.inputs().pixels();
                for (host::OracleSample& s : samples)
                    if (!skipped && s.own < GNO_NO_CASTER) s.own = GNO_NO_CASTER;
                host::FrameInputs inputs(passes, subject.frame(), samples, subject.inputs().width());
                inputs.setLight(subject.inputs().light(), base.cull);
                const auto with = [&](const char* name, const Names& queries) {
                    return tally(variants.get(name), queries, subject, inputs, base.seeds, progress, fmt::format("{} {}", scene, name));
                };
                Tally shipped = with(kAsShipped, {"psv", "d-hybrid"});
                const double all = mean(shipped.exact["d-hybrid"]);
                const auto counted = [&](const char* name) { return mean(with(name, {"d-hybrid"}).exact["d-hybrid"]); };
                const auto share = [&](const char* name) { return all > 0 ? fmt::format("{:.0f} %", 100 * counted(name) / all) : std::string("-"); };
                const std::string atCaps = share("calls_at_caps"), beside = skipped ? share("calls_beside_own") : "-";
                const double integers = counted("calls_in_integers");
                progress.clear();
                fmt::print("| {} | {} | {} | {} | {} | {} | {:.4f} | {:.4f} | {} | {} | {:.5f} | {} |\n", stem(scene), light, inputs.sampleCount(),
                           skipped ? "skipped" : "not told", statistic(shipped.nodes["psv"]).text(1), statistic(shipped.nodes["d-hybrid"]).text(1),
                           mean(shipped.exact["psv"]), all, atCaps, beside, integers, shipped.wrong);
                std::fflush(stdout);
            }
        }
    }
    fmt::print(
        "\nAn exact call is one plane's exact sign; fp32 gives most of them at the caster's own vertices, the integers the rest. Shares and "
        "integers "
        "are d-hybrid's. Beside own: the\n"
        "cap's owner shares a vertex with the sample's own caster, or its plane holds all of it.\n");
}

}  // namespace gno::bench
