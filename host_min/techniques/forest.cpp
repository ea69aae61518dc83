// SPDX-License-Identifier: MIT
#include "host_min/techniques/forest.hpp"

#include <fmt/format.h>

#include "host_min/techniques/forest_trees.hpp"
#include "host_min/techniques/query_pass.hpp"

namespace gno::host {
namespace {

class ForestTechnique final : public Technique {
public:
    ForestTechnique() {
        info_.name = "forest";
        info_.paper = "this project: a grid of TOP trees over the directions of the light";
        info_.precisions = {Precision::conservative, Precision::certified};
        info_.effects = {"point_light", "directional_light", "spot_light", "open_casters"};
        info_.settings = {
            {"cells",
             "along an edge of a face of the light's grid; auto: by what counting at several finds",
             0,
             0,
             {"auto", "1", "4", "8", "16", "32", "64", "128", "256"},
             "auto"},
            {"view_cull", "leave out casters beyond a cell's view samples; off: the trees outlive a camera's moves", 0, 0, {"on", "off"}, "on"},
            {"cover", "leave out casters beyond one that hides the whole cell", 0, 0, {"on", "off"}, "on"},
            {"query", "which query of the TOP tree", 0, 0, {"stack", "stackless", "hybrid"}, "hybrid"},
            {"stack", "entries of the query's stack", 1, 64, {}, "12"},
            {"slab", "keep bounds of a node's children in the node", 0, 0, {"on", "off"}, "off"},
            {"nodes", "bytes of a caster's nodes in each cell: with its planes, or computed anew at each visit", 0, 0, {"128", "64"}, "128"},
            {"pool", "pairs of cell and caster the pool holds; 0: as many as the frame needs, by one read-back", 0, 2097152, {}, "0"},
            {"seed", "of the random insertion order", 0, 4294967295u, {}, "1"},
            {"stage", "shader stage of the timed query", 0, 0, {"compute", "fragment"}, "compute"}};
    }

    const TechniqueInfo& info() const override { return info_; }

    TechniqueResult run(const FrameInputs& inputs, StructureCache& structures, const Settings& settings, const RunOptions& options) override {
        const ForestOptions forestOptions{.precision = options.precision,
                                          .resolution = settings.word("cells") == "auto" ? 0 : uint32_t(std::stoul(settings.word("cells"))),
                                          .viewCull = settings.word("view_cull") == "on",
                                          .cover = settings.word("cover") == "on",
                                          .slab = settings.word("slab") == "on",
                                          .storePlanes = settings.word("nodes") == "128",
                                          .pool = settings.number("pool"),
                                          .seed = settings.number("seed"),
                                          .repeat = options.repeat,
                                          .warmUp = options.warmUp,
                                          .counters = options.counters};
        const std::string key =
            fmt::format("forest {} {} {} {} {} {} {} {}", name(options.precision), forestOptions.resolution, forestOptions.viewCull,
                        forestOptions.cover, forestOptions.slab, forestOptions.storePlanes, forestOptions.pool, forestOptions.seed);
        const ForestTrees& trees = structures.get<ForestTrees>(key, [&] { return std::make_shared<ForestTrees>(inputs, forestOptions); });

        TechniqueResult result;
        result.passes = trees.passes();
        result.bytes = trees.bytes();
        ask(inputs,
            {"forest/examples/query_" + settings.word("query"),
             {{0, uint32_t(options.precision)}, {1, settings.number("stack")}, {2, 1}, {3, forestOptions.slab}, {4, forestOptions.storePlanes}},
             trees.resources(),
             "forest_query",
             settings.word("stage") == "fragment"},
            options, result);
        result.counters.dropped = trees.counters().dropped;
        result.counters.more = {{"cells", trees.resolution()},           {"pairs", trees.found().pairs},
                                {"used_cells", trees.found().used},      {"some_cells", trees.found().some},
                                {"many_cells", trees.found().many},      {"inserted", trees.counters().inserted},
                                {"build_steps", trees.counters().steps}, {"intersection_steps", trees.counters().intersections}};
        if (options.dump) result.dump = trees.dump();
        return result;
    }

private:
    TechniqueInfo info_;
};

}  // namespace

std::unique_ptr<Technique> makeForestTechnique() { return std::make_unique<ForestTechnique>(); }

}  // namespace gno::host
