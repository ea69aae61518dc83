// SPDX-License-Identifier: MIT
#include "host_min/techniques/light_grid.hpp"

#include <fmt/format.h>

#include "host_min/techniques/light_grid_lists.hpp"
#include "host_min/techniques/query_pass.hpp"

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
             "entries of each pool (pairs of cell and caster; items of lists); 0: as many as the frame needs, by one read-back each",
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

    TechniqueResult run(const FrameInputs& inputs, StructureCache& structures, const Settings& settings, const RunOptions& options) override {
        const LightGridOptions gridOptions{uint32_t(std::stoul(settings.word("cells"))),
                                           settings.number("nest"),
                                           settings.word("view_cull") == "on",
                                           settings.word("cover") == "on",
                                           settings.number("pool"),
                                           settings.word("caster_planes") == "stored",
                                           options.repeat,
                                           options.warmUp};
        const std::string key = fmt::format("light grid {} {} {} {} {} {}", gridOptions.resolution, gridOptions.nest, gridOptions.viewCull,
                                            gridOptions.cover, gridOptions.pool, gridOptions.planes);
        const LightGridLists& lists = structures.get<LightGridLists>(key, [&] { return std::make_shared<LightGridLists>(inputs, gridOptions); });

        TechniqueResult result;
        result.passes = lists.passes();
        result.bytes = lists.bytes();
        ask(inputs,
            {gridOptions.planes ? "rivals/examples/light_grid_query_planes" : "rivals/examples/light_grid_query",
             {{0, uint32_t(options.precision)}},
             lists.resources(),
             "light_grid_query",
             settings.word("stage") == "fragment"},
            options, result);
        result.counters.more = {{"pairs", lists.pairs()}, {"items", lists.items()}, {"nested_cells", lists.nests()}};
        if (options.dump) result.dump = lists.dump();
        return result;
    }

private:
    TechniqueInfo info_;
};

}  // namespace

std::unique_ptr<Technique> makeLightGridTechnique() { return std::make_unique<LightGridTechnique>(); }

}  // namespace gno::host
