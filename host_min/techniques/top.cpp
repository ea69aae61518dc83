// SPDX-License-Identifier: MIT
#include "host_min/techniques/top.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host_min/techniques/measure.hpp"
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
        case TopQuery::psv: return {"psv", "query_stack", "trace_stack", 32, false};
        case TopQuery::dPsv: return {"d-psv", "query_stack", "trace_stack", 32, true};
        case TopQuery::dStackless: return {"d-stackless", "query_stackless", "trace_stackless", 0, true};
        case TopQuery::dHybrid: break;
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
        if (variant_.stack > 0)
            info_.settings.push_back({"stack", "entries of the query's stack", 1, 64, {}, std::to_string(variant_.stack)});
        info_.settings.push_back({"seed", "of the random insertion order", 0, 4294967295u, {}, "1"});
        info_.settings.push_back({"stage", "shader stage of the timed query", 0, 0, {"compute", "fragment"}, "compute"});
        info_.settings.push_back({"group", "invocations per work group of set-up and build", 1, 1024, {}, "64"});
    }

    const TechniqueInfo& info() const override { return info_; }

    TechniqueResult run(const FrameInputs& inputs, StructureCache& structures, const Settings& settings, const RunOptions& options) override {
        const TopTreeOptions treeOptions{options.precision, settings.number("seed"), settings.number("group"), options.repeat, options.warmUp, options.counters};
        const std::string key = fmt::format("top {} {} {}", name(options.precision), treeOptions.seed, treeOptions.groupSize);
        const TopTree& tree = structures.get<TopTree>(key, [&] { return std::make_shared<TopTree>(inputs, treeOptions); });

        TechniqueResult result;
        result.passes = tree.passes();
        result.bytes = {{"tree", tree.bytes()}};
        Image visibility(inputs.device(), inputs.width(), inputs.height(), vk::Format::eR32Uint);
        visibility.clear(vk::ClearColorValue(kPoison, kPoison, kPoison, kPoison));
        if (options.counters) count(inputs, tree, settings, options, visibility, result);
        const bool fragment = settings.word("stage") == "fragment";
        const auto times = measure(inputs.device(), options.repeat, options.warmUp, [&](Recording& recording) {
            recording.beginPass("top_query");
            query(recording, inputs, tree, settings, options, visibility, nullptr, fragment);
            recording.endPass();
        });
        result.passes.push_back({times.front().name, times.front().ms});
        result.visibility = visibility.downloadAs<uint32_t>();
        if (options.dump) {
            result.dump.push_back({"planes", "vec4 plane[4 * casters]", tree.planes().download(), 4});
            result.dump.push_back({"links", "GnoTopLink link[4 * casters]", tree.links().download(), 4});
            result.dump.push_back({"header", "GnoTopHeader", tree.header().download(), 4});
            if (options.counters) {
                const TracedPixel pixel = tracedPixel(inputs, options, result);
                for (DumpedBuffer& buffer : traceTopQuery(inputs, tree, variant_.trace, constants(settings, options), pixel)) result.dump.push_back(std::move(buffer));
                result.traced = options.trace;
            }
        }
        return result;
    }

private:
    static constexpr uint32_t kPoison = 0xDEADBEEFu;  // a shader that writes nothing must not look right

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

    void query(Recording& recording, const FrameInputs& inputs, const TopTree& tree, const Settings& settings, const RunOptions& options, const Image& visibility,
               const Image* counts, bool fragment) const {
        const std::string base = fmt::format("top/examples/{}", variant_.shader);
        const ExamplePush push = inputs.push();
        const auto bytes = std::as_bytes(std::span(&push, 1));
        const std::array resources{Binding{"gnoCasters", &inputs.casters()},  Binding{"gnoTopPlanes", &tree.planes()}, Binding{"gnoTopLinks", &tree.links()},
                                   Binding{"gnoTopHeader", &tree.header()},   Binding{"gnoSamples", &inputs.samples()}, Binding{"gnoVisibility", &visibility},
                                   Binding{"gnoCounts", counts ? counts : &inputs.samples()}};
        if (fragment) {
            const std::array formats{visibility.format()};
            const RasterPass& pass = inputs.passes().raster("core/examples/fullscreen.vert", base + ".frag", formats, false, constants(settings, options));
            const std::array targets{RasterPass::Target{&visibility, vk::ClearColorValue(kPoison, kPoison, kPoison, kPoison)}};
            pass.draw(recording, targets, nullptr, resources, bytes, 3);
        } else {
            const ComputePass& pass = inputs.passes().compute(base + (counts ? ".comp.counters" : ".comp"), constants(settings, options));
            pass.dispatch(recording, resources, bytes, (inputs.width() + 7) / 8, (inputs.height() + 7) / 8);
        }
    }

    void count(const FrameInputs& inputs, const TopTree& tree, const Settings& settings, const RunOptions& options, const Image& visibility,
               TechniqueResult& result) const {
        Image counts(inputs.device(), inputs.width(), inputs.height(), vk::Format::eR32G32B32A32Uint);
        counts.clear(vk::ClearColorValue(kPoison, kPoison, kPoison, kPoison));
        Recording recording(inputs.device());
        query(recording, inputs, tree, settings, options, visibility, &counts, false);
        recording.submit();
        RecordCounters& totals = result.counters;
        for (const glm::uvec4& pixel : counts.downloadAs<glm::uvec4>()) {
            result.visitedNodes.push_back(pixel.x);
            result.deepestStack.push_back(pixel.y);
            totals.visitedNodes += pixel.x;
            totals.maxStack = std::max<uint64_t>(totals.maxStack, pixel.y);
            totals.stackOverflows += pixel.z;
            totals.exactCalls += pixel.w;
        }
        totals.dropped = tree.counters().dropped;
        totals.more = {{"inserted", tree.counters().inserted},
                       {"build_steps", tree.counters().steps},
                       {"intersection_steps", tree.counters().intersections}};
    }

    Variant variant_;
    TechniqueInfo info_;
};

}  // namespace

std::unique_ptr<Technique> makeTopTechnique(TopQuery query) { return std::make_unique<TopTechnique>(query); }

}  // namespace gno::host
