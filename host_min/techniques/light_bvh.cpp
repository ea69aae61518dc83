// SPDX-License-Identifier: MIT
#include "host_min/techniques/light_bvh.hpp"

#include <fmt/format.h>

#include "host_min/techniques/light_bvh_tree.hpp"

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
                          {"pool", "references the pool holds; 0: chosen from the casters, enlarged when too small", 0, 2097152, {}, "0"},
                          {"stage", "shader stage of the timed query", 0, 0, {"compute", "fragment"}, "compute"}};
    }

    const TechniqueInfo& info() const override { return info_; }

    std::string structureKey(const FrameInputs&, const Settings& settings, const RunOptions&) const override {
        return fmt::format("light-bvh {}", settings.number("pool"));
    }

    std::unique_ptr<Structure> makeStructure(const FrameInputs&, const Settings& settings, const RunOptions&) const override {
        return std::make_unique<LightBvhTree>(LightBvhOptions{settings.number("pool")});
    }

    std::string overLimit(const DeviceFacts& device, const FrameLoad& load, const Settings&) const override {
        return lightBvhOverLimit(device, load);
    }

    Query query(const Structure& structure, const FrameInputs& inputs, const Settings& settings, const RunOptions& options) const override {
        const LightBvhQueryOptions asked{.precision = uint32_t(options.precision),
                                         .stackless = settings.word("query") == "stackless",
                                         .stack = settings.number("stack"),
                                         .fragment = settings.word("stage") == "fragment"};
        return {lightBvhQueryPasses(inputs.width(), inputs.height(), asked), dynamic_cast<const LightBvhTree&>(structure).bindings()};
    }

    void read(const Structure& structure, const FrameInputs&, const Settings&, const RunOptions& options, TechniqueResult& result) const override {
        const auto& tree = dynamic_cast<const LightBvhTree&>(structure);
        result.bytes = tree.bytes();
        result.counters.more = {{"references", tree.references()}, {"nodes", tree.nodes()}, {"levels", tree.levels()}};
        if (options.dump) result.dump = tree.dump();
    }

private:
    TechniqueInfo info_;
};

}  // namespace

std::unique_ptr<Technique> makeLightBvhTechnique() { return std::make_unique<LightBvhTechnique>(); }

}  // namespace gno::host
