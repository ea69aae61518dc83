// SPDX-License-Identifier: MIT
#include "host_min/techniques/top.hpp"

#include <fmt/format.h>

#include <string>

#include "host_min/techniques/query_pass.hpp"
#include "host_min/techniques/top_trace.hpp"
#include "host_min/techniques/top_tree.hpp"

namespace gno::host {
namespace {

struct Variant {
    const char* name;
    const char* shader;  ///< of glsl/top/examples, without its ending
    const char* trace;   ///< the same query, logging the nodes it loads
    uint32_t stack;      ///< default; 0: it has none
    bool depthTest;
};

constexpr Variant variantOf(TopQuery query) {
    switch (query) {
        case TopQuery::psv:
            return {"psv", "query_stack", "trace_stack", 32, false};
        case TopQuery::dPsv:
            return {"d-psv", "query_stack", "trace_stack", 32, true};
        case TopQuery::dStackless:
            return {"d-stackless", "query_stackless", "trace_stackless", 0, true};
        case TopQuery::dHybrid:
            break;
    }
    return {"d-hybrid", "query_hybrid", "trace_hybrid", 12, true};
}

class TopTechnique final : public Technique {
public:
    explicit TopTechnique(TopQuery query) : variant_(variantOf(query)) {
        info_.name = variant_.name;
        info_.paper = "Deep Partitioned Shadow Volumes, EGSR 2016";
        info_.precisions = {Precision::published, Precision::conservative, Precision::certified};
        info_.traces = true;
        info_.effects = {"point_light", "directional_light", "spot_light", "open_casters"};
        if (variant_.stack > 0) info_.settings.push_back({"stack", "entries of the query's stack", 1, 64, {}, std::to_string(variant_.stack)});
        info_.settings.push_back({"seed", "of the random insertion order", 0, 4294967295u, {}, "1"});
        info_.settings.push_back({"stage", "shader stage of the timed query", 0, 0, {"compute", "fragment"}, "compute"});
        info_.settings.push_back({"group", "invocations per work group of set-up and build", 1, 1024, {}, "64"});
    }

    const TechniqueInfo& info() const override { return info_; }

    TechniqueResult run(const FrameInputs& inputs, StructureCache& structures, const Settings& settings, const RunOptions& options) override {
        const TopTreeOptions treeOptions{options.precision, settings.number("seed"), settings.number("group"),
                                         options.repeat,    options.warmUp,          options.counters};
        const std::string key = fmt::format("top {} {} {}", name(options.precision), treeOptions.seed, treeOptions.groupSize);
        const TopTree& tree = structures.get<TopTree>(key, [&] { return std::make_shared<TopTree>(inputs, treeOptions); });

        TechniqueResult result;
        result.passes = tree.passes();
        result.bytes = {{"tree", tree.bytes()}};
        ask(inputs,
            {std::string("top/examples/") + variant_.shader,
             constants(settings, options),
             {{"gnoTopPlanes", &tree.planes()}, {"gnoTopLinks", &tree.links()}, {"gnoTopHeader", &tree.header()}},
             "top_query",
             settings.word("stage") == "fragment"},
            options, result);
        result.counters.dropped = tree.counters().dropped;
        result.counters.more = {
            {"inserted", tree.counters().inserted}, {"build_steps", tree.counters().steps}, {"intersection_steps", tree.counters().intersections}};
        if (options.dump) {
            result.dump.push_back({"planes", "vec4 plane[4 * casters]", tree.planes().download(), 4});
            result.dump.push_back({"links", "GnoTopLink link[4 * casters]", tree.links().download(), 4});
            result.dump.push_back({"header", "GnoTopHeader", tree.header().download(), 4});
            if (options.counters) {
                const TracedPixel pixel = tracedPixel(inputs, options, result);
                for (DumpedBuffer& buffer : traceTopQuery(inputs, tree, variant_.trace, constants(settings, options), pixel))
                    result.dump.push_back(std::move(buffer));
                result.traced = options.trace;
            }
        }
        return result;
    }

private:
    /// Room for as many nodes as the instrumented query counted.
    static TracedPixel tracedPixel(const FrameInputs& inputs, const RunOptions& options, const TechniqueResult& result) {
        if (!options.trace) return {};
        return {*options.trace, result.visitedNodes[size_t(options.trace->y) * inputs.width() + options.trace->x]};
    }

    Specialization constants(const Settings& settings, const RunOptions& options) const {
        Specialization result{{0, uint32_t(options.precision)}, {2, variant_.depthTest ? 1u : 0u}};
        if (variant_.stack > 0) result[1] = settings.number("stack");
        return result;
    }

    Variant variant_;
    TechniqueInfo info_;
};

}  // namespace

std::unique_ptr<Technique> makeTopTechnique(TopQuery query) { return std::make_unique<TopTechnique>(query); }

}  // namespace gno::host
