// SPDX-License-Identifier: MIT
// gnomon forest/passes.hpp : a forest of TOP trees on the host's side: arrays, passes and barriers, defaults, the choice of R (glsl/MODULES.md tells
// the story). C++20, standard library only. rivals/light_grid_passes.hpp begins with the same cells.
//
// Per light: one forest, with a grid of its own. Per frame: all build passes again when casters, their states or the light changed, and, with
// viewCull, when the view did; nothing to reset. You write gnoForestGrid (core/grid.hpp, forestGrid) when the light, the scene's box or R changes.
// The pool: how many pairs of cell and caster there will be nobody knows beforehand. Begin with forestFirstPool(), read GnoForestHeader::pairs when
// the frame is done (no wait within it), and make the pool forestPoolFor(pairs) when it is larger than the pool was: that frame's answers were
// unknown, ask it again.
#ifndef GNO_FOREST_PASSES_HPP
#define GNO_FOREST_PASSES_HPP
#include <cmath>

#include "../core/grid.hpp"
#include "../core/pass.hpp"

namespace gno {

/// What the cells are made from; all that the first half, casters in cells, depends on.
struct LightCells {
    std::uint32_t casters = 0;            ///< triangles
    std::uint32_t width = 0, height = 0;  ///< pixels
    std::uint32_t resolution = 64;        ///< R: cells along an edge of a face, a power of two
    std::uint32_t faces = 6;              ///< forestFaces(light)
    bool viewCull = true;                 ///< casters beyond a cell's view samples are left out: build again when the view moves
    bool cover = true;                    ///< casters beyond one that hides the whole cell are left out

    [[nodiscard]] constexpr std::uint32_t count() const { return faces * resolution * resolution; }
};

struct ForestOptions {
    std::uint32_t precision = 2;  ///< GNO_PRECISION_CONSERVATIVE or _CERTIFIED; the same in build and query
    std::uint32_t seed = 1;       ///< of the random insertion order: GnoExamplePush::seed
    bool slab = false;            ///< bounds of a node's children are kept: 64 bytes more for each pair
    bool storePlanes = true;      ///< false: build and query compute a node's plane from its caster: 64 bytes less for each pair
};

inline constexpr std::uint32_t kForestGroup = 64;  ///< GNO_FOREST_GROUP
inline constexpr std::uint32_t kMostForestGroups = 65535;

/// A pool of at least `pairs`. Its buffer's length is the capacity that shaders see, so it is even: drivers and allocators round to 16 bytes.
constexpr std::uint64_t forestPool(std::uint64_t pairs) { return pairs < 2 ? 2 : (pairs + 1) / 2 * 2; }
/// For a first frame, by the number of casters that are kept (or of all).
constexpr std::uint64_t forestFirstPool(std::uint64_t casters) { return forestPool(2 * casters + 4096); }
/// When a frame had `pairs`: with room for what the next ones have more.
constexpr std::uint64_t forestPoolFor(std::uint64_t pairs) { return forestPool(pairs + pairs / 4); }
/// More pairs do not fit one binding (maxStorageBufferRange), or one row of work groups.
constexpr std::uint64_t forestMostPairs(std::uint64_t storageRange) {
    const std::uint64_t binding = storageRange / 64, groups = std::uint64_t{kMostForestGroups} * kForestGroup;
    return (binding < groups ? binding : groups) / 2 * 2;
}

/// What a build and a query cost together, in visited nodes of a query: a pair costs as much as 65, a cell as 4, a sample visits 5.5 times the 0.3rd
/// power of the pairs that a used cell holds in the mean. Fitted to 13 scenes at 1920x1080 (validation/measured/forest.md of the project).
inline double forestVisits(std::uint64_t pairs, std::uint64_t used, std::uint64_t samples, std::uint64_t cells) {
    return 65.0 * double(pairs) + 4.0 * double(cells) + double(samples) * 5.5 * std::pow(double(pairs) / double(used > 0 ? used : 1), 0.3);
}

/// Resolutions worth a look.
inline constexpr std::array<std::uint32_t, 7> kForestResolutions{4, 8, 16, 32, 64, 128, 256};

/// R from what the host knows before the frame (casters that are kept, or all): the power of two nearest to a tenth of the square root of the view
/// samples (or pixels), 4 .. 256. Against what counting finds (`cells=counted` of this project's host; show_garden, cooktop, fence, truck_peterbilt,
/// two lights, 160x120 and 512x512): the same or one step beside it in 16 of 18. Where casters are far more than samples, small cells pay by what
/// view culling leaves out of them.
inline std::uint32_t forestResolution(std::uint64_t casters, std::uint64_t samples) {
    if (casters > 16 * samples) return 128;
    const double wanted = std::sqrt(double(samples)) / 10.0;
    std::uint32_t resolution = kForestResolutions.front();
    while (resolution < kForestResolutions.back() && double(resolution) * std::sqrt(2.0) < wanted) resolution *= 2;
    return resolution;
}

/// The arrays of the first half: cells, and which casters they keep.
inline ArrayList lightCellArrays(const LightCells& cells, std::uint64_t pool) {
    const std::uint64_t n = cells.casters > 0 ? cells.casters : 1;
    return {{"gnoForestGrid", 3, 0, "GnoForestGrid: forestGrid()", 48, kUsageUniform, First::host},
            {"gnoForestCells", 3, 1, "GnoForestCell[cells]", 16ull * cells.count()},
            {"gnoForestPairs", 3, 2, "GnoForestPair[pool]; its length is the capacity", 8 * pool},
            {"gnoForestHeader", 3, 3, "GnoForestHeader", 60, kUsageStorage | kUsageIndirect, First::anything, Kept::forBuild},
            {"gnoForestFew", 3, 4, "GnoForestFew[casters]", 8 * n, kUsageStorage, First::anything, Kept::forBuild},
            {"gnoList", 2, 1, "uint[casters]: with some cells from its front on, with many from its back", 4 * n, kUsageStorage, First::anything,
             Kept::forBuild}};
}

inline ArrayList forestArrays(const LightCells& cells, std::uint64_t pool, const ForestOptions& options) {
    ArrayList arrays = lightCellArrays(cells, pool);
    arrays.push_back({"gnoTopPlanes", 1, 0, "vec4[4 pool]; without storePlanes bound and not used", options.storePlanes ? 64 * pool : 16});
    arrays.push_back({"gnoTopLinks", 1, 1, "GnoTopLink[4 pool]", 64 * pool});
    arrays.push_back({"gnoTopHeader", 1, 2, "GnoTopHeader: of all trees, may they be asked?", 16});
    arrays.push_back({"gnoTopSlabs", 1, 3, "GnoTopSlab[4 pool]; without slab bound and not used", options.slab ? 64 * pool : 16});
    return arrays;
}

/// Empty cells, then how far their view samples lie.
inline PassList lightCellDepthPasses(const LightCells& cells, std::string_view part) {
    PassList list{{.shader = "forest/examples/reset.comp",
                   .part = part,
                   .before = kBeforeShaders,
                   .groups = {groupsFor(cells.count(), kForestGroup), 1, 1},
                   .writes = {"gnoForestCells", "gnoForestHeader"}}};
    if (cells.viewCull)
        list.push_back({.shader = "forest/examples/depth.comp",
                        .part = part,
                        .before = kBeforeShaders,
                        .groups = {groupsFor(cells.width, 32), groupsFor(cells.height, 16), 1},
                        .writes = {"gnoForestCells"}});
    return list;
}

/// What a step of forest/assign.glsl does with the casters: 3 cover, 4 count, 6 emit.
enum class AssignStep : std::uint32_t { cover = 3, count = 4, emit = 6 };

inline Few<Constant, 8> assignConstants(const LightCells& cells, AssignStep step) {
    return {{"kViewCull", cells.viewCull ? 1u : 0u}, {"kUseCover", cells.cover ? 1u : 0u}, {"kStep", static_cast<std::uint32_t>(step)}};
}

/// Casters by the number of their cells.
inline PassList lightCellSortPasses(const LightCells& cells, std::string_view part) {
    return {{.shader = "forest/examples/sort.comp",
             .part = part,
             .before = kBeforeShaders,
             .groups = {groupsFor(cells.casters, kForestGroup), 1, 1},
             .constants = assignConstants(cells, AssignStep::cover),
             .writes = {"gnoForestHeader", "gnoForestFew", "gnoList"}},
            {.shader = "forest/examples/sizes.comp", .part = part, .before = kBeforeShaders, .writes = {"gnoForestHeader"}}};
}

/// The larger casters first: `many`, `some`, `few`; in the last step they come first into their cells' trees, being the better pivots. Cover and
/// count are minima and sums by atomics, in any order; barriers stand between their passes all the same, because validation sees one buffer written
/// twice.
inline PassList lightCellAssignPasses(const LightCells& cells, AssignStep step, std::string_view part) {
    const Few<Constant, 8> constants = assignConstants(cells, step);
    const Few<std::string_view, 12> writes{"gnoForestCells", "gnoForestPairs", "gnoForestHeader"};  // pairs and header in the last step only
    PassList list{{.shader = "forest/examples/assign_many.comp",
                   .part = part,
                   .before = kBeforeShaders | kBeforeIndirect,
                   .indirect = "gnoForestHeader",
                   .indirectOffset = 32,
                   .constants = constants,
                   .writes = writes},
                  {.shader = "forest/examples/assign_some.comp",
                   .part = part,
                   .before = kBeforeShaders | kBeforeIndirect,
                   .indirect = "gnoForestHeader",
                   .indirectOffset = 16,
                   .constants = constants,
                   .writes = writes}};
    if (step != AssignStep::cover)
        list.push_back({.shader = "forest/examples/assign_few.comp",
                        .part = part,
                        .before = kBeforeShaders,
                        .groups = {groupsFor(cells.casters, kForestGroup), 1, 1},
                        .constants = constants,
                        .writes = writes});
    return list;
}

inline void append(PassList& list, const PassList& more) { list.insert(list.end(), more.begin(), more.end()); }

/// What hides cells, and how many casters each keeps.
inline PassList lightCellCountPasses(const LightCells& cells, std::string_view part) {
    PassList list;
    if (cells.cover) append(list, lightCellAssignPasses(cells, AssignStep::cover, part));
    append(list, lightCellAssignPasses(cells, AssignStep::count, part));
    return list;
}

/// Casters in cells, counted, and the trees' places in the pool: GnoForestHeader::pairs and ::used are known behind it.
inline PassList forestCountPasses(const LightCells& cells) {
    PassList list = lightCellDepthPasses(cells, "forest_setup_depth");
    append(list, lightCellSortPasses(cells, "forest_setup_sort"));
    append(list, lightCellCountPasses(cells, "forest_setup_count"));
    list.push_back({.shader = "forest/examples/allocate.comp",
                    .part = "forest_setup_count",
                    .before = kBeforeShaders,
                    .groups = {groupsFor(cells.count(), kForestGroup), 1, 1},
                    .writes = {"gnoForestCells", "gnoForestHeader"}});
    list.push_back({.shader = "forest/examples/sizes.comp", .part = "forest_setup_count", .before = kBeforeShaders, .writes = {"gnoForestHeader"}});
    return list;
}

/// All of the build. You: casters, states (core/caster_state.glsl) and view samples visible before.
inline PassList forestBuildPasses(const LightCells& cells, const ForestOptions& options) {
    PassList list = forestCountPasses(cells);
    append(list, lightCellAssignPasses(cells, AssignStep::emit, "forest_setup_emit"));
    Pass overPairs{
        .shader = "forest/examples/set_up.comp",
        .part = "forest_setup",
        .before = kBeforeShaders | kBeforeIndirect,
        .indirect = "gnoForestHeader",
        .constants = {{"kPrecision", options.precision}, {"kSlab", options.slab ? 1u : 0u}, {"kStorePlanes", options.storePlanes ? 1u : 0u}},
        .writes = {"gnoTopPlanes", "gnoTopLinks", "gnoTopSlabs", "gnoTopHeader"}};
    list.push_back(overPairs);
    overPairs.shader = "forest/examples/build.comp";
    overPairs.part = "forest_build";
    overPairs.before = kBeforeShaders;
    overPairs.writes = {"gnoForestCells", "gnoTopLinks", "gnoTopSlabs", "gnoTopHeader"};
    list.push_back(overPairs);
    return list;
}

enum class ForestQuery : std::uint8_t { stack, stackless, hybrid };

struct ForestQueryOptions {
    ForestQuery query = ForestQuery::hybrid;
    std::uint32_t stack = 12;  ///< entries; no meaning for stackless
    bool fragment = false;
};

/// One answer per pixel of width x height view samples. `options` are those of the build.
inline PassList forestQueryPasses(std::uint32_t width, std::uint32_t height, const ForestOptions& options, const ForestQueryOptions& query) {
    constexpr std::string_view shaders[3][2] = {{"forest/examples/query_stack.comp", "forest/examples/query_stack.frag"},
                                                {"forest/examples/query_stackless.comp", "forest/examples/query_stackless.frag"},
                                                {"forest/examples/query_hybrid.comp", "forest/examples/query_hybrid.frag"}};
    Pass pass{.shader = shaders[static_cast<int>(query.query)][query.fragment ? 1 : 0],
              .part = "forest_query",
              .before = kBeforeShaders,
              .groups = {groupsFor(width, 8), groupsFor(height, 8), 1},
              .constants = {{"kPrecision", options.precision},
                            {"kDepthTest", 1},
                            {"kSlab", options.slab ? 1u : 0u},
                            {"kStorePlanes", options.storePlanes ? 1u : 0u}},
              .writes = {"gnoVisibility"},
              .kind = query.fragment ? PassKind::fullscreen : PassKind::compute};
    if (query.query != ForestQuery::stackless) pass.constants.push_back({"kStackSize", query.stack});
    return {pass};
}

}  // namespace gno
#endif
