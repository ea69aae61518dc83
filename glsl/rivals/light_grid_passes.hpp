// SPDX-License-Identifier: MIT
// gnomon rivals/light_grid_passes.hpp : lists of casters per cell of the light's grid, on the host's side: arrays, passes and barriers, defaults.
// C++20, standard library only. The first half is the forest's (lightCell... of forest/passes.hpp).
//
// Per light: one of all. Per frame: all build passes again when casters, their states or the light changed, and, with viewCull, when the view did;
// nothing to reset. You write gnoForestGrid when the light, the scene's box or the resolution changes.
// Two pools: pairs of cell and caster (GnoForestHeader::pairs) and items of lists (GnoLightGridHeader::items). Begin with lightGridFirstPools(),
// read both headers when the frame is done, enlarge what was too small (forestPoolFor): that frame's answers were unknown, ask it again. Items are
// counted from pairs, so the first count holds only when the pairs had room.
#ifndef GNO_RIVALS_LIGHT_GRID_PASSES_HPP
#define GNO_RIVALS_LIGHT_GRID_PASSES_HPP
#include "../forest/passes.hpp"

namespace gno {

struct LightGridOptions {
    std::uint32_t nest = 8;  ///< a cell with more casters gets 8 x 8 sub cells; 0: none does
    bool planes = true;      ///< a query asks the casters' planes first, 64 bytes each
};

struct LightGridPools {
    std::uint64_t pairs = 2, items = 2;  ///< forestPool() of what is needed
};

/// For a first frame, by the number of casters that are kept (or of all): sub cells hold some casters more than once.
constexpr LightGridPools lightGridFirstPools(std::uint64_t casters) { return {forestFirstPool(casters), forestPool(4 * casters + 16384)}; }

/// Cells that can have more than `nest` casters each: room for the sub cells of all of them, unless that passes one binding (storageRange bytes); a
/// cell that finds no room stays one list, longer and right.
constexpr std::uint64_t lightGridNests(const LightCells& cells, std::uint64_t pairs, std::uint32_t nest, std::uint64_t storageRange) {
    if (nest == 0) return 0;
    const std::uint64_t needed = pairs / (std::uint64_t{nest} + 1), own = (cells.count() + std::uint64_t{63}) / 64 * 64;
    const std::uint64_t least = needed < cells.count() ? needed : cells.count(), room = storageRange / 8 > own ? (storageRange / 8 - own) / 64 : 0;
    return least < room ? least : room;
}

inline ArrayList lightGridArrays(const LightCells& cells, const LightGridPools& pools, std::uint64_t nests, const LightGridOptions& options) {
    const std::uint64_t n = cells.casters > 0 ? cells.casters : 1, own = (cells.count() + std::uint64_t{63}) / 64 * 64;
    ArrayList arrays = lightCellArrays(cells, pools.pairs);
    for (Array& array : arrays)
        if (array.name == "gnoForestCells" || array.name == "gnoForestPairs") array.kept = Kept::forBuild;
    arrays.push_back({"gnoGridLists", 1, 0, "GnoLightGridList[cells in whole 64 + 64 nests]", 8 * (own + 64 * nests)});
    arrays.push_back({"gnoGridItems", 1, 1, "GnoLightGridItem[items]; its length is the capacity", 8 * pools.items});
    arrays.push_back({"gnoGridDepths", 1, 2, "uint[64 nests]; its length says how many cells may be nested", nests > 0 ? 256 * nests : 16,
                      kUsageStorage, First::anything, Kept::forBuild});
    arrays.push_back({"gnoGridHeader", 1, 3, "GnoLightGridHeader", 52, kUsageStorage | kUsageIndirect, First::zero});
    arrays.push_back({"gnoGridPlanes", 1, 4, "vec4[4 casters]; without planes bound and not used", options.planes ? 64 * n : 16});
    return arrays;
}

/// All of the build. You: casters, states (core/caster_state.glsl) and view samples visible before.
inline PassList lightGridBuildPasses(const LightCells& cells, const LightGridOptions& options) {
    constexpr std::string_view depth = "light_grid_setup_depth", count = "light_grid_setup_count", nest = "light_grid_setup_nest";
    const Pass overPairs{.shader = "rivals/examples/light_grid_pairs.comp",
                         .part = nest,
                         .before = kBeforeShaders | kBeforeIndirect,
                         .indirect = "gnoGridHeader",
                         .constants = {{"kViewCull", cells.viewCull ? 1u : 0u}},
                         .writes = {"gnoGridLists", "gnoGridItems", "gnoGridHeader"}};  // step 5 counts in lists; items and header in step 7
    const Pass overLists{.shader = "", .part = nest, .before = kBeforeShaders | kBeforeIndirect, .indirect = "gnoGridHeader", .indirectOffset = 16};

    PassList list = lightCellDepthPasses(cells, depth);
    list.insert(list.begin() + 1,  // behind the first one's barrier, beside it
                {.shader = "rivals/examples/light_grid_reset.comp", .part = depth, .before = kBeforeNothing, .writes = {"gnoGridHeader"}});
    append(list, lightCellSortPasses(cells, depth));
    append(list, lightCellCountPasses(cells, count));
    list.push_back({.shader = "rivals/examples/light_grid_open.comp",
                    .part = count,
                    .before = kBeforeShaders,
                    .groups = {groupsFor(cells.count(), kForestGroup), 1, 1},
                    .constants = {{"kNest", options.nest}},
                    .writes = {"gnoForestCells", "gnoForestHeader", "gnoGridLists", "gnoGridDepths", "gnoGridHeader"}});
    list.push_back({.shader = "rivals/examples/light_grid_sizes.comp", .part = count, .before = kBeforeShaders, .writes = {"gnoGridHeader"}});
    append(list, lightCellAssignPasses(cells, AssignStep::emit, "light_grid_setup_pairs"));
    if (options.nest > 0) {
        if (cells.viewCull)
            list.push_back({.shader = "rivals/examples/light_grid_depth.comp",
                            .part = nest,
                            .before = kBeforeShaders,
                            .groups = {groupsFor(cells.width, 8), groupsFor(cells.height, 8), 1},
                            .writes = {"gnoGridDepths"}});
        list.push_back(overPairs);
        list.back().constants.push_back({"kStep", 5});
    }
    list.push_back(overLists);
    list.back().shader = "rivals/examples/light_grid_allocate.comp";
    list.back().writes = {"gnoGridLists", "gnoGridHeader"};
    list.push_back(overPairs);
    list.back().part = "light_grid_setup_items";
    list.back().constants.push_back({"kStep", 7});
    list.push_back(overLists);
    list.back().shader = "rivals/examples/light_grid_sort.comp";
    list.back().part = "light_grid_setup_sort";
    list.back().writes = {"gnoGridItems", "gnoGridHeader"};
    if (options.planes)
        list.push_back({.shader = "rivals/examples/light_grid_planes.comp",
                        .part = "light_grid_setup_planes",
                        .before = kBeforeShaders,
                        .groups = {groupsFor(cells.casters, kForestGroup), 1, 1},
                        .writes = {"gnoGridPlanes", "gnoGridHeader"}});
    return list;
}

/// One answer per pixel of width x height view samples.
inline PassList lightGridQueryPasses(std::uint32_t width, std::uint32_t height, std::uint32_t precision, const LightGridOptions& options,
                                     bool fragment) {
    constexpr std::string_view shaders[2][2] = {{"rivals/examples/light_grid_query.comp", "rivals/examples/light_grid_query.frag"},
                                                {"rivals/examples/light_grid_query_planes.comp", "rivals/examples/light_grid_query_planes.frag"}};
    return {{.shader = shaders[options.planes ? 1 : 0][fragment ? 1 : 0],
             .part = "light_grid_query",
             .before = kBeforeShaders,
             .groups = {groupsFor(width, 8), groupsFor(height, 8), 1},
             .constants = {{"kPrecision", precision}},
             .writes = {"gnoVisibility"},
             .kind = fragment ? PassKind::fullscreen : PassKind::compute}};
}

}  // namespace gno
#endif
