// SPDX-License-Identifier: MIT
#include "host_min/techniques/light_bvh.hpp"

#include <fmt/format.h>

#include "host_min/techniques/light_bvh_tree.hpp"
#include "host_min/techniques/query_pass.hpp"

namespace gno::host {
namespace {

class LightBvhTechnique final : public Technique {
public:
    LightBvhTechnique() {
        info_.name = "light-bvh";
        info_.paper = "light-space bounding volume hierarchy, built after Karras 2012";
        info_.precisions = {Precision::conservative, Precision::certified};
        info_.effects = {"point_light", "directional_light", "spot_light", "open_casters"};
        info_.settings = {{"query", "with a stack, or by the parents' links alone", 0, 0, {"stack", "stackless"}, "stack"},
                          {"stack", "entries of the query's stack", 1, 64, {}, "32"},
                          {"pool", "references the pool holds; 0: as many as the frame needs, by one read-back", 0, 2097152, {}, "0"},
                          {"stage", "shader stage of the timed query", 0, 0, {"compute", "fragment"}, "compute"}};
    }

    const TechniqueInfo& info() const override { return info_; }

    TechniqueResult run(const FrameInputs& inputs, StructureCache& structures, const Settings& settings, const RunOptions& options) override {
        const LightBvhOptions treeOptions{settings.number("pool"), options.repeat, options.warmUp};
        const std::string key = fmt::format("light-bvh {}", treeOptions.pool);
        const LightBvhTree& tree = structures.get<LightBvhTree>(key, [&] { return std::make_shared<LightBvhTree>(inputs, treeOptions); });

        TechniqueResult result;
        result.passes = tree.passes();
        result.bytes = tree.bytes();
        ask(inputs,
            {"rivals/examples/light_bvh_query_" + settings.word("query"),
             {{0, uint32_t(options.precision)}, {1, settings.number("stack")}},
             tree.resources(),
             "light_bvh_query",
             settings.word("stage") == "fragment"},
            options, result);
        result.counters.more = {{"references", tree.references()}, {"nodes", tree.nodes()}, {"levels", tree.levels()}};
        if (options.dump) result.dump = tree.dump();
        return result;
    }

private:
    TechniqueInfo info_;
};

}  // namespace

std::unique_ptr<Technique> makeLightBvhTechnique() { return std::make_unique<LightBvhTechnique>(); }

}  // namespace gno::host
