// SPDX-License-Identifier: MIT
// gnomon rivals/light_bvh_passes.hpp : a light-space hierarchy on the host's side: arrays, passes and barriers, how large the pool is
// (glsl/MODULES.md tells the story). C++20, standard library only (light_bvh.h needs GLM in C++; this does not include it).
//
// Per light: one hierarchy. Per frame: all build passes again when casters, their states or the light changed; nothing to reset. After it you read
// `references` (at kLightBvhReferencesAt of gnoLightBvhHeader): more than the pool holds, and no answer means anything: take a larger pool, once
// more.
#ifndef GNO_RIVALS_LIGHT_BVH_PASSES_HPP
#define GNO_RIVALS_LIGHT_BVH_PASSES_HPP
#include "../core/pass.hpp"

namespace gno {

inline constexpr std::uint32_t kLightBvhReferencesAt = 12;  ///< bytes: GnoLightBvhHeader::references

/// A pool that a first frame does well with. A light at infinity: a reference for each caster, never more. A point light: some casters lie on
/// several faces of its cube. `casters`: those that are kept, or all when you do not know how many are. Later frames: a quarter more than
/// `references` told.
constexpr std::uint64_t lightBvhFirstPool(std::uint64_t casters, bool directional) { return directional ? casters : casters + casters / 4 + 4096; }

/// References that an array for `pool` of them holds: a multiple of 4, so that no array of words is longer than the others by its padding.
constexpr std::uint64_t lightBvhCapacity(std::uint64_t pool) { return pool == 0 ? 4 : (pool + 3) / 4 * 4; }

/// The most that one storage buffer of `maxStorageBufferRange` bytes and one row of 65535 work groups allow.
constexpr std::uint64_t lightBvhMostReferences(std::uint64_t maxStorageBufferRange) {
    const std::uint64_t bound = maxStorageBufferRange / 64, passed = 65535ull * 64;
    return (bound < passed ? bound : passed) / 4 * 4;
}

/// Boxes of the row above a row, and of all rows over so many references (gnoLightBvhNextRow, gnoLightBvhBoxes).
constexpr std::uint64_t lightBvhNextRow(std::uint64_t boxes) { return (boxes + 7) / 8; }
constexpr std::uint64_t lightBvhBoxes(std::uint64_t references) {
    std::uint64_t all = references;
    for (std::uint64_t row = references; row > 1;) all += row = lightBvhNextRow(row);
    return all;
}

/// The most nodes over so many references (gnoLightBvhNodes), and words of the sort's counts (gnoSortCounts).
constexpr std::uint64_t lightBvhNodes(std::uint64_t references) { return 2 * (references / 3) + 8; }
constexpr std::uint64_t lightBvhSortCounts(std::uint64_t references) { return 16 * ((references + 1023) / 1024); }

/// GNO_LIGHT_BVH_SET's arrays and the sort's, for `casters` casters and a pool of `pool` references.
inline ArrayList lightBvhArrays(std::uint64_t casters, std::uint64_t pool) {
    const std::uint64_t n = casters > 0 ? casters : 1, r = lightBvhCapacity(pool);
    constexpr std::uint32_t storage = kUsageStorage, counted = kUsageStorage | kUsageIndirect;
    constexpr First anything = First::anything;
    constexpr Kept build = Kept::forBuild;
    return {// You write it when light or scene change: a grid of forest/cells.h with GNO_LIGHT_BVH_RESOLUTION cells along an edge.
            {"gnoLightBvhGrid", 1, 0, "GnoForestGrid", 48, kUsageUniform, First::host},
            {"gnoLightBvhHeader", 1, 1, "GnoLightBvhHeader", 64, counted},
            {"gnoLightBvhNode", 1, 2, "GnoLightBvhNode[2/3 references + 8]", 64 * lightBvhNodes(r)},
            {"gnoLightBvhParents", 1, 3, "uint[2/3 references + 8]", 4 * lightBvhNodes(r)},
            {"gnoLightBvhMasks", 1, 4, "uint[casters]", 4 * n, storage, anything, build},
            {"gnoLightBvhSums", 1, 5, "uint[casters / 64]", 4 * ((n + 63) / 64), storage, anything, build},
            {"gnoLightBvhLevels", 1, 6, "GnoLightBvhLevel[56]", 56 * 20, counted, anything, build},
            {"gnoLightBvhReferences", 1, 7, "GnoLightBvhBox[references]", 16 * r, storage, anything, build},
            {"gnoLightBvhKeys", 1, 8, "uint[references]", 4 * r, storage, anything, build},
            {"gnoLightBvhOrder", 1, 9, "uint[references]", 4 * r, storage, anything, build},
            {"gnoSortedKeys", 2, 16, "uint[references]", 4 * r, storage, anything, build},
            {"gnoSortedOrder", 2, 17, "uint[references]", 4 * r, storage, anything, build},
            {"gnoSortCountWords", 2, 15, "uint[references / 64]", 4 * lightBvhSortCounts(r), storage, anything, build},
            {"gnoLightBvhBoxes_", 1, 10, "GnoLightBvhBox[8/7 references]", 16 * lightBvhBoxes(r), storage, anything, build},
            {"gnoLightBvhSplits", 1, 11, "GnoLightBvhBox[references]", 16 * r, storage, anything, build}};
}

/// The hierarchy of all casters that are kept. You: casters and states (core/caster_state.glsl) visible before.
inline PassList lightBvhBuildPasses(std::uint32_t casters, std::uint64_t pool) {
    constexpr std::uint32_t group = 64, levels = 56, levelBytes = 20, groupsOfReferences = 0, groupsOfTiles = 16;
    const std::array<std::uint32_t, 3> overCasters{groupsFor(casters, group), 1, 1};
    PassList passes{{.shader = "rivals/examples/light_bvh_count.comp",
                     .part = "light_bvh_setup_count",
                     .groups = overCasters,
                     .writes = {"gnoLightBvhMasks", "gnoLightBvhSums", "gnoLightBvhHeader"}},
                    {.shader = "rivals/examples/light_bvh_begin.comp",
                     .part = "light_bvh_setup_count",
                     .writes = {"gnoLightBvhSums", "gnoLightBvhHeader", "gnoLightBvhLevels"}},
                    {.shader = "rivals/examples/light_bvh_emit.comp",
                     .part = "light_bvh_setup_emit",
                     .groups = overCasters,
                     .writes = {"gnoLightBvhReferences", "gnoLightBvhKeys", "gnoLightBvhOrder", "gnoLightBvhHeader"}}};
    for (std::uint32_t round = 0; round < 8; ++round) {  // even rounds sort into the second pair of arrays, odd ones back
        Few<Renamed, 6> from, all;
        if (round % 2 != 0) {
            from = {{"gnoLightBvhKeys", "gnoSortedKeys"}};
            all = {{"gnoLightBvhKeys", "gnoSortedKeys"},
                   {"gnoLightBvhOrder", "gnoSortedOrder"},
                   {"gnoSortedKeys", "gnoLightBvhKeys"},
                   {"gnoSortedOrder", "gnoLightBvhOrder"}};
        }
        const Pass count{.shader = "rivals/examples/light_bvh_sort_count.comp",
                         .part = "light_bvh_setup_sort",
                         .before = kBeforeShaders | (round == 0 ? kBeforeIndirect : kBeforeNothing),
                         .indirect = "gnoLightBvhHeader",
                         .indirectOffset = groupsOfTiles,
                         .number = 4 * round,
                         .writes = {"gnoSortCountWords"},
                         .renamed = from};
        passes.push_back(count);
        passes.push_back({.shader = "rivals/examples/light_bvh_sort_prefix.comp",
                          .part = count.part,
                          .number = count.number,
                          .writes = {"gnoSortCountWords"},
                          .renamed = from});
        passes.push_back({.shader = "rivals/examples/light_bvh_sort_scatter.comp",
                          .part = count.part,
                          .indirect = count.indirect,
                          .indirectOffset = count.indirectOffset,
                          .number = count.number,
                          .writes = {"gnoSortedKeys", "gnoSortedOrder"},
                          .renamed = all});
    }
    passes.push_back({.shader = "rivals/examples/light_bvh_leaves.comp",
                      .part = "light_bvh_build",
                      .indirect = "gnoLightBvhHeader",
                      .indirectOffset = groupsOfReferences,
                      .writes = {"gnoLightBvhBoxes_"}});
    std::uint32_t row = 1;
    for (std::uint64_t boxes = lightBvhCapacity(pool); boxes > 1; ++row) {
        boxes = lightBvhNextRow(boxes);
        passes.push_back({.shader = "rivals/examples/light_bvh_up.comp",
                          .part = "light_bvh_build",
                          .groups = {groupsFor(boxes, group), 1, 1},
                          .number = row,
                          .writes = {"gnoLightBvhBoxes_"}});
    }
    passes.push_back({.shader = "rivals/examples/light_bvh_split.comp",
                      .part = "light_bvh_build",
                      .indirect = "gnoLightBvhHeader",
                      .indirectOffset = groupsOfReferences,
                      .writes = {"gnoLightBvhHeader", "gnoLightBvhLevels", "gnoLightBvhNode", "gnoLightBvhParents", "gnoLightBvhSplits"}});
    for (std::uint32_t level = 0; level < levels; ++level)
        passes.push_back({.shader = "rivals/examples/light_bvh_collapse.comp",
                          .part = "light_bvh_build_collapse",
                          .before = kBeforeShaders | kBeforeIndirect,
                          .indirect = "gnoLightBvhLevels",
                          .indirectOffset = level * levelBytes,
                          .number = level,
                          .writes = {"gnoLightBvhLevels", "gnoLightBvhNode", "gnoLightBvhParents", "gnoLightBvhHeader"}});
    return passes;
}

struct LightBvhQueryOptions {
    std::uint32_t precision = 2;  ///< GNO_PRECISION_*: conservative or certified
    bool stackless = false;       ///< by the parents' links alone
    std::uint32_t stack = 32;     ///< entries; no meaning for stackless
    bool fragment = false;
};

/// One answer per pixel of width x height view samples.
inline PassList lightBvhQueryPasses(std::uint32_t width, std::uint32_t height, const LightBvhQueryOptions& options) {
    constexpr std::string_view shaders[2][2] = {
        {"rivals/examples/light_bvh_query_stack.comp", "rivals/examples/light_bvh_query_stack.frag"},
        {"rivals/examples/light_bvh_query_stackless.comp", "rivals/examples/light_bvh_query_stackless.frag"}};
    Pass pass{.shader = shaders[options.stackless ? 1 : 0][options.fragment ? 1 : 0],
              .part = "light_bvh_query",
              .groups = {groupsFor(width, 8), groupsFor(height, 8), 1},
              .constants = {{"kPrecision", options.precision}},
              .writes = {"gnoVisibility"},
              .kind = options.fragment ? PassKind::fullscreen : PassKind::compute};
    if (!options.stackless) pass.constants.push_back({"kStackSize", options.stack});
    return {pass};
}

}  // namespace gno
#endif
