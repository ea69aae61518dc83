// SPDX-License-Identifier: MIT
#include "host_min/techniques/light_grid.hpp"

#include <fmt/format.h>

#include "host_min/techniques/light_grid_lists.hpp"

namespace gno::host {
namespace {

class LightGridTechnique final : public Technique {
public:
    LightGridTechnique() {
        info_.name = "light-grid";
        info_.paper = "this project: casters in order of depth per cell of a grid over the directions of the light";
        info_.precisions = {Precision::conservative, Precision::certified};
        info_.effects = {"point_light", "directional_light", "spot_light", "open_casters"};
        info_.settings = {
            {"cells", "along an edge of a face of the light's grid", 0, 0, {"1", "4", "8", "16", "32", "64", "128", "256"}, "64"},
            {"nest", "a cell with more casters is divided into 8 x 8; 0: none is", 0, 1000000, {}, "8"},
            {"view_cull", "leave out casters beyond a cell's view samples; off: the lists outlive a camera's moves", 0, 0, {"on", "off"}, "on"},
            {"cover", "leave out casters beyond one that hides the whole cell", 0, 0, {"on", "off"}, "on"},
            {"pool",
             "entries of each pool (pairs of cell and caster; items of lists); 0: by casters, and by what the frame before needed",
             0,
             2097152,
             {},
             "0"},
            {"caster_planes",
             "stored: 64 bytes per caster, asked before its vertices; computed: the vertices decide at once",
             0,
             0,
             {"stored", "computed"},
             "stored"},
            {"stage", "shader stage of the timed query", 0, 0, {"compute", "fragment"}, "compute"}};
    }

    const TechniqueInfo& info() const override { return info_; }

    std::string structureKey(const FrameInputs&, const Settings& settings, const RunOptions&) const override {
        std::string key = "light grid";
        for (const char* setting : {"cells", "view_cull", "cover", "caster_planes"}) key += " " + settings.word(setting);
        return fmt::format("{} {} {}", key, settings.number("nest"), settings.number("pool"));
    }

    std::unique_ptr<Structure> makeStructure(const FrameInputs&, const Settings& settings, const RunOptions&) const override {
        return std::make_unique<LightGridLists>(
            LightGridSettings{.options = {.nest = settings.number("nest"), .planes = settings.word("caster_planes") == "stored"},
                              .resolution = uint32_t(std::stoul(settings.word("cells"))),
                              .viewCull = settings.word("view_cull") == "on",
                              .cover = settings.word("cover") == "on",
                              .pool = settings.number("pool")});
    }

    std::string overLimit(const DeviceFacts& device, const FrameLoad& load, const Settings&) const override {
        return lightCellsOverLimit(device, load);
    }

    Query query(const Structure& structure, const FrameInputs& inputs, const Settings& settings, const RunOptions& options) const override {
        const auto& lists = dynamic_cast<const LightGridLists&>(structure);
        return {lightGridQueryPasses(inputs.width(), inputs.height(), uint32_t(options.precision), lists.options(),
                                     settings.word("stage") == "fragment"),
                lists.bindings()};
    }

    void read(const Structure& structure, const FrameInputs&, const Settings&, const RunOptions& options, TechniqueResult& result) const override {
        const auto& lists = dynamic_cast<const LightGridLists&>(structure);
        result.bytes = lists.bytes();
        result.counters.more = {
            {"pairs", lists.pairs()}, {"items", lists.items()}, {"nested_cells", lists.nests()}, {"crowded_cells", lists.crowded()}};
        if (options.dump) result.dump = lists.dump();
    }

private:
    TechniqueInfo info_;
};

}  // namespace

std::unique_ptr<Technique> makeLightGridTechnique() { return std::make_unique<LightGridTechnique>(); }

}  // namespace gno::host
