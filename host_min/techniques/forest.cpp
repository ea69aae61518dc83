// SPDX-License-Identifier: MIT
#include "host_min/techniques/forest.hpp"

#include <fmt/format.h>

#include "host_min/techniques/forest_trees.hpp"

namespace gno::host {
namespace {

class ForestTechnique final : public Technique {
public:
    ForestTechnique() {
        info_.name = "forest";
        info_.paper = "this project: a grid of TOP trees over the directions of the light";
        info_.precisions = {Precision::conservative, Precision::certified};
        info_.hostWaits = true;  // with cells=counted, not otherwise
        info_.effects = {"point_light", "directional_light", "spot_light", "open_casters"};
        info_.settings = {
            {"cells",
             "along an edge of a face of the light's grid; auto: by casters, view samples and faces; counted: by counting at several, the host "
             "waits",
             0,
             0,
             {"auto", "counted", "1", "4", "8", "16", "32", "64", "128", "256"},
             "auto"},
            {"view_cull", "leave out casters beyond a cell's view samples; off: the trees outlive a camera's moves", 0, 0, {"on", "off"}, "on"},
            {"cover", "leave out casters beyond one that hides the whole cell", 0, 0, {"on", "off"}, "on"},
            {"query", "which query of the TOP tree", 0, 0, {"stack", "stackless", "hybrid"}, "hybrid"},
            {"stack", "entries of the query's stack", 1, 64, {}, "12"},
            {"slab", "keep bounds of a node's children in the node", 0, 0, {"on", "off"}, "off"},
            {"nodes", "bytes of a caster's nodes in each cell: with its planes, or computed anew at each visit", 0, 0, {"128", "64"}, "128"},
            {"pool", "pairs of cell and caster the pool holds; 0: by casters, and by what the frame before needed", 0, 2097152, {}, "0"},
            {"seed", "of the random insertion order", 0, 4294967295u, {}, "1"},
            {"stage", "shader stage of the timed query", 0, 0, {"compute", "fragment"}, "compute"}};
    }

    const TechniqueInfo& info() const override { return info_; }

    std::string structureKey(const FrameInputs&, const Settings& settings, const RunOptions&) const override {
        std::string key = "forest";
        for (const char* setting : {"cells", "view_cull", "cover", "slab", "nodes"}) key += " " + settings.word(setting);
        return fmt::format("{} {} {}", key, settings.number("pool"), settings.number("seed"));
    }

    std::unique_ptr<Structure> makeStructure(const FrameInputs&, const Settings& settings, const RunOptions& options) const override {
        const std::string cells = settings.word("cells");
        ForestSettings forest{.options = {.precision = uint32_t(options.precision),
                                          .seed = settings.number("seed"),
                                          .slab = settings.word("slab") == "on",
                                          .storePlanes = settings.word("nodes") == "128"},
                              .choice = cells == "auto"      ? CellChoice::known
                                        : cells == "counted" ? CellChoice::counted
                                                             : CellChoice::given,
                              .viewCull = settings.word("view_cull") == "on",
                              .cover = settings.word("cover") == "on",
                              .pool = settings.number("pool")};
        if (forest.choice == CellChoice::given) forest.resolution = uint32_t(std::stoul(cells));
        return std::make_unique<ForestTrees>(forest);
    }

    std::string overLimit(const DeviceFacts& device, const FrameLoad& load, const Settings&) const override {
        return lightCellsOverLimit(device, load);
    }

    Query query(const Structure& structure, const FrameInputs& inputs, const Settings& settings, const RunOptions&) const override {
        const auto& trees = dynamic_cast<const ForestTrees&>(structure);
        const std::string word = settings.word("query");
        return {forestQueryPasses(inputs.width(), inputs.height(), trees.options(),
                                  {.query = word == "stack"       ? ForestQuery::stack
                                            : word == "stackless" ? ForestQuery::stackless
                                                                  : ForestQuery::hybrid,
                                   .stack = settings.number("stack"),
                                   .fragment = settings.word("stage") == "fragment"}),
                trees.bindings()};
    }

    void read(const Structure& structure, const FrameInputs&, const Settings&, const RunOptions& options, TechniqueResult& result) const override {
        const auto& trees = dynamic_cast<const ForestTrees&>(structure);
        result.bytes = trees.bytes();
        result.counters.dropped = trees.counters().dropped;
        result.counters.more = {{"cells", trees.resolution()},           {"pairs", trees.found().pairs},
                                {"used_cells", trees.found().used},      {"some_cells", trees.found().some},
                                {"many_cells", trees.found().many},      {"inserted", trees.counters().inserted},
                                {"build_steps", trees.counters().steps}, {"intersection_steps", trees.counters().intersections}};
        if (options.dump) result.dump = trees.dump();
    }

private:
    TechniqueInfo info_;
};

}  // namespace

std::unique_ptr<Technique> makeForestTechnique() { return std::make_unique<ForestTechnique>(); }

}  // namespace gno::host
