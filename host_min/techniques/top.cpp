// SPDX-License-Identifier: MIT
#include "host_min/techniques/top.hpp"

#include <fmt/format.h>

#include <string>

#include "host_min/techniques/top_trace.hpp"
#include "host_min/techniques/top_tree.hpp"

namespace gno::host {
namespace {

struct Variant {
    const char* name;
    TopQuery query;
    const char* trace;  ///< the same query, logging the nodes it loads
    uint32_t stack;     ///< default; 0: it has none
    bool depthTest;
};

constexpr Variant variantOf(TopTechniqueName name) {
    switch (name) {
        case TopTechniqueName::psv:
            return {"psv", TopQuery::stack, "trace_stack", 32, false};
        case TopTechniqueName::dPsv:
            return {"d-psv", TopQuery::stack, "trace_stack", 32, true};
        case TopTechniqueName::dStackless:
            return {"d-stackless", TopQuery::stackless, "trace_stackless", 0, true};
        case TopTechniqueName::dHybrid:
            break;
    }
    return {"d-hybrid", TopQuery::hybrid, "trace_hybrid", 12, true};
}

class TopTechnique final : public Technique {
public:
    explicit TopTechnique(TopTechniqueName name) : variant_(variantOf(name)) {
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

    std::string structureKey(const FrameInputs&, const Settings& settings, const RunOptions&) const override {
        return fmt::format("top {} {}", settings.number("seed"), settings.number("group"));
    }

    std::unique_ptr<Structure> makeStructure(const FrameInputs&, const Settings& settings, const RunOptions& options) const override {
        return std::make_unique<TopTree>(TopOptions{uint32_t(options.precision), settings.number("seed"), settings.number("group")});
    }

    std::string overLimit(const DeviceFacts& device, const FrameLoad& load, const Settings& settings) const override {
        return topOverLimit(device, load, {.groupSize = settings.number("group")});
    }

    Query query(const Structure& structure, const FrameInputs& inputs, const Settings& settings, const RunOptions& options) const override {
        return {topQueryPasses(inputs.width(), inputs.height(), queryOptions(settings, options)),
                dynamic_cast<const TopTree&>(structure).bindings()};
    }

    void read(const Structure& structure, const FrameInputs& inputs, const Settings& settings, const RunOptions& options,
              TechniqueResult& result) const override {
        const auto& tree = dynamic_cast<const TopTree&>(structure);
        result.bytes = {{"tree", tree.bytes()}};
        result.counters.dropped = tree.counters().dropped;
        result.counters.more = {
            {"inserted", tree.counters().inserted}, {"build_steps", tree.counters().steps}, {"intersection_steps", tree.counters().intersections}};
        if (!options.dump) return;
        result.dump.push_back({"planes", "vec4 plane[4 * casters]", tree.planes().download(), 4});
        result.dump.push_back({"links", "GnoTopLink link[4 * casters]", tree.links().download(), 4});
        result.dump.push_back({"header", "GnoTopHeader", tree.header().download(), 4});
        if (!options.counters) return;
        const TracedPixel pixel = tracedPixel(inputs, options, result);
        const Pass asked = topQueryPasses(inputs.width(), inputs.height(), queryOptions(settings, options)).front();
        for (DumpedBuffer& buffer : traceTopQuery(inputs, tree, variant_.trace, asked, pixel)) result.dump.push_back(std::move(buffer));
        result.traced = options.trace;
    }

private:
    /// Room for as many nodes as the instrumented query counted.
    static TracedPixel tracedPixel(const FrameInputs& inputs, const RunOptions& options, const TechniqueResult& result) {
        if (!options.trace) return {};
        return {*options.trace, result.visitedNodes[size_t(options.trace->y) * inputs.width() + options.trace->x]};
    }

    TopQueryOptions queryOptions(const Settings& settings, const RunOptions& options) const {
        return {.query = variant_.query,
                .precision = uint32_t(options.precision),
                .stack = variant_.stack > 0 ? settings.number("stack") : 0,
                .depthTest = variant_.depthTest,
                .fragment = settings.word("stage") == "fragment"};
    }

    Variant variant_;
    TechniqueInfo info_;
};

}  // namespace

std::unique_ptr<Technique> makeTopTechnique(TopTechniqueName name) { return std::make_unique<TopTechnique>(name); }

}  // namespace gno::host
