// SPDX-License-Identifier: MIT
// gnomon clusters/passes.hpp : a view-sample cluster hierarchy on the host's side: arrays, passes and barriers, defaults (glsl/MODULES.md tells the
// story). C++20, standard library only (cluster.h needs GLM in C++; this does not include it, a test holds both together).
//
// Per light: all of it, since hierarchy and traversal work on the light's view samples. Lights that are shaded one after the other may share every
// array; keep header, masks, shade, slices and the uniform block until the light's query is done. Per frame: all build passes again; nothing else to
// reset. You write gnoClusterFrame (clusterUniform) before the frame when camera, casters, culling or options changed.
#ifndef GNO_CLUSTERS_PASSES_HPP
#define GNO_CLUSTERS_PASSES_HPP
#include <bit>

#include "../core/grid.hpp"
#include "../core/pass.hpp"

namespace gno {

/// Where a node's bounds come from; numbers of cluster.h.
enum class ClusterForm : std::uint32_t {
    implicitBounds = 0,  ///< its key alone
    explicitBounds = 1,  ///< a box for every node of the full tree
    compact = 2,         ///< boxes of existing nodes only
    flat = 3,            ///< 2011: tile and depth range
};

struct ClusterOptions {
    std::uint32_t precision = 2;  ///< GNO_PRECISION_*; the same in all passes
    ClusterForm form = ClusterForm::compact;
    std::uint32_t split = 2;               ///< depth at which the first pass leaves jobs for the second, 0: one pass
    bool extraPlanes = true;               ///< cull by the three extra planes as well
    std::uint32_t groups = 64;             ///< work groups of 32 invocations that traverse; any number is right: as many as the device runs at once
    std::uint32_t jobCapacity = 1u << 20;  ///< with a split; a job that finds the list full is finished in place: right, but not balanced
    std::uint32_t boxCapacity = 1u << 19;  ///< compact; nodes that find the list full use implicit bounds: right, but slower
    bool layers = false;                   ///< look up what casters let through: you bind gnoMaterialOf, gnoSurfaces, gnoMaterials, gnoTexels, too
};

/// GnoClusterLayout: 48 bytes.
struct ClusterLayout {
    std::uint32_t levels = 0, bits = 0, sliceBits = 0;
    ClusterForm form = ClusterForm::compact;
    std::array<std::uint32_t, 2> tiles{};
    std::uint32_t maskX = 0, maskY = 0, maskZ = 0;
    std::array<std::uint32_t, 3> unused{};
};
static_assert(sizeof(ClusterLayout) == 48);

/// What gnoClusterFrame holds: 144 bytes, std140.
struct ClusterUniform {
    ClusterFrame frame;
    ClusterLayout layout;
};
static_assert(sizeof(ClusterUniform) == 144);

inline constexpr std::uint32_t kClusterTile = 8, kClusterMostBits = 29;  ///< pixels; of a key (compact: one less)
inline constexpr std::uint32_t kClusterGroupsAt = 32;                    ///< bytes: GnoClusterHeader::groups

constexpr std::uint32_t clusterTileHeight(ClusterForm form) { return form == ClusterForm::flat ? 4 : kClusterTile; }

/// Of an image of up to 8192 x 8192.
constexpr ClusterLayout clusterLayout(std::uint32_t width, std::uint32_t height, ClusterForm form) {
    ClusterLayout layout;
    layout.form = form;
    layout.tiles = {groupsFor(width, kClusterTile), groupsFor(height, clusterTileHeight(form))};
    std::uint32_t x = std::uint32_t(std::bit_width(layout.tiles[0] - 1)), y = std::uint32_t(std::bit_width(layout.tiles[1] - 1)), z = 0;
    if (form != ClusterForm::flat) {
        x = y = std::max(x, y);
        z = std::min(x + 2, kClusterMostBits - (form == ClusterForm::compact ? 1 : 0) - 2 * x);
    }
    layout.sliceBits = z;
    for (std::uint32_t i = 0; i < 16; ++i) {  // interleaved from the low end
        if (i < x) layout.maskX |= 1u << layout.bits++;
        if (i < y) layout.maskY |= 1u << layout.bits++;
        if (i < z) layout.maskZ |= 1u << layout.bits++;
    }
    layout.bits = std::max(layout.bits, 1u);
    layout.levels = (layout.bits + 4) / 5;
    return layout;
}

/// Inner nodes (32-bit words of gnoClusterMasks) at depth 0 .. levels - 1, all of them, and nodes without the root.
constexpr std::uint32_t clusterWordsAt(const ClusterLayout& layout, std::uint32_t depth) {
    return depth == 0 ? 1u : 1u << (layout.bits - 5 * (layout.levels - depth));
}
constexpr std::uint32_t clusterWordCount(const ClusterLayout& layout) {
    std::uint32_t sum = 0;
    for (std::uint32_t depth = 0; depth < layout.levels; ++depth) sum += clusterWordsAt(layout, depth);
    return sum;
}
constexpr std::uint32_t clusterNodeCount(const ClusterLayout& layout) { return clusterWordCount(layout) - 1 + (1u << layout.bits); }
constexpr std::uint32_t clusterSlices(const ClusterLayout& layout) { return 1u << layout.sliceBits; }
constexpr std::uint32_t clusterShadeWords(const ClusterLayout& layout) {
    return layout.tiles[0] * layout.tiles[1] * (clusterTileHeight(layout.form) / 4);
}

/// Boxes of gnoClusterLow and gnoClusterHigh, and bytes of one of them.
constexpr std::uint64_t clusterBoxes(const ClusterLayout& layout, const ClusterOptions& options) {
    if (layout.form == ClusterForm::implicitBounds) return 0;
    return layout.form == ClusterForm::compact ? options.boxCapacity : clusterNodeCount(layout);
}
constexpr std::uint64_t clusterBoxBytes(ClusterForm form) { return form == ClusterForm::flat ? 4 : 12; }

/// The most casters that one binding of `storageRange` bytes (maxStorageBufferRange) and one row of 65,535 work groups hold.
constexpr std::uint64_t clusterMostCasters(std::uint64_t storageRange) {
    const std::uint64_t bound = storageRange / 112, groups = 64ull * 65535;
    return bound < groups ? bound : groups;
}

/// gnoClusterFrame's contents. `frame` is clusterFrame() of the camera (core/grid.hpp); `frontCulled`: casters that face the light are left out
/// (GNO_CULL_FRONT).
constexpr ClusterUniform clusterUniform(ClusterFrame frame, std::uint32_t casters, bool frontCulled, const ClusterOptions& options) {
    frame.casterCount = casters;
    frame.jobCapacity = options.split > 0 ? options.jobCapacity : 0;
    frame.boxCapacity = options.form == ClusterForm::compact ? options.boxCapacity : 0;
    frame.split = options.split;
    frame.extraPlanes = options.extraPlanes ? 1 : 0;
    frame.frontCulled = frontCulled ? 1 : 0;
    return {frame, clusterLayout(frame.size[0], frame.size[1], options.form)};
}

/// GNO_CLUSTER_SET's arrays for an image of width x height and `casters` casters; with layers the sums of core/material_bindings.glsl, too. Those
/// that a form has no use for are bound as well, 16 bytes.
inline ArrayList clusterArrays(std::uint32_t width, std::uint32_t height, std::uint64_t casters, const ClusterOptions& options) {
    const ClusterLayout layout = clusterLayout(width, height, options.form);
    const std::uint64_t words = clusterWordCount(layout), boxes = clusterBoxes(layout, options) * clusterBoxBytes(options.form);
    const auto some = [](std::uint64_t bytes) { return bytes < 16 ? 16 : bytes; };
    const bool compact = options.form == ClusterForm::compact;
    ArrayList arrays{
        {"gnoClusterFrame", 1, 0, "GnoClusterFrame, GnoClusterLayout: clusterUniform()", sizeof(ClusterUniform), kUsageUniform, First::host},
        {"gnoClusterHeader", 1, 1, "GnoClusterHeader", 64, kUsageStorage | kUsageIndirect},
        {"gnoClusterSliceTable", 1, 2, "float[slices + 1]", 4 * (std::uint64_t(clusterSlices(layout)) + 1)},
        {"gnoClusterMasks", 1, 3, "uint[words]", 4 * words},
        {"gnoClusterShade", 1, 4, "uint[2 tiles], flat: uint[tiles]", 4 * std::uint64_t(clusterShadeWords(layout))},
        {"gnoClusterLow", 1, 5, "float[3 boxes], flat: float[nodes]", some(boxes), kUsageStorage, First::anything, Kept::forBuild},
        {"gnoClusterHigh", 1, 6, "the same", some(boxes), kUsageStorage, First::anything, Kept::forBuild},
        {"gnoClusterPointers", 1, 7, "uvec2[words], compact only", some(compact ? 8 * words : 0), kUsageStorage, First::anything, Kept::forBuild},
        {"gnoClusterVolumes", 1, 8, "vec4[7 casters]", some(112 * casters), kUsageStorage, First::anything, Kept::forBuild},
        {"gnoClusterInfo", 1, 9, "uvec2[casters]", some(8 * casters), kUsageStorage, First::anything, Kept::forBuild},
        {"gnoClusterJobs", 1, 10, "uvec2[jobs], with a split", some(options.split > 0 ? 8 * std::uint64_t(options.jobCapacity) : 0), kUsageStorage,
         First::anything, Kept::forBuild}};
    if (options.layers) arrays.push_back({"gnoTransmittances", 3, 5, "uvec4[pixels]", 16 * std::uint64_t(width) * height});
    return arrays;
}

namespace cluster_passes {

/// Groups of 64 in rows below the 65,535 that every device allows on an axis.
constexpr std::array<std::uint32_t, 3> rowsOf64(std::uint32_t count) {
    const std::uint32_t groups = groupsFor(count, 64), columns = std::min(groups, 32768u);
    return {columns, (groups + columns - 1) / columns, 1};
}

constexpr std::uint32_t kMasks = 1, kBounds = 2;  // GNO_CLUSTER_MASKS_OF_NODES, GNO_CLUSTER_BOUNDS_OF_NODES

/// Tiles, then level by level up to the root's children.
inline void appendClimb(PassList& passes, const ClusterLayout& layout, std::uint32_t what) {
    const std::uint32_t form = std::uint32_t(layout.form);
    passes.push_back({.shader = "clusters/examples/tiles.comp",
                      .part = "cluster_build",
                      .before = kBeforeShaders,
                      .groups = {layout.tiles[0], layout.tiles[1], 1},
                      .constants = {{"kForm", form}, {"kWhat", what}, {"kGroupSize", kClusterTile * clusterTileHeight(layout.form)}},
                      .writes = {"gnoClusterHeader", "gnoClusterMasks", "gnoClusterLow", "gnoClusterHigh"}});
    for (std::uint32_t depth = layout.levels - 1; depth > 0; --depth)
        passes.push_back({.shader = "clusters/examples/up.comp",
                          .part = "cluster_build",
                          .before = kBeforeShaders,
                          .groups = rowsOf64(clusterWordsAt(layout, depth)),
                          .number = depth,
                          .constants = {{"kForm", form}, {"kWhat", what}},
                          .writes = {"gnoClusterHeader", "gnoClusterMasks", "gnoClusterLow", "gnoClusterHigh"}});
}

inline Pass traversal(const ClusterOptions& options, std::uint32_t which) {
    Pass pass{.shader = options.layers ? "clusters/examples/traverse_layers.comp" : "clusters/examples/traverse.comp",
              .part = which == 1 ? "cluster_expand" : "cluster_finish",
              .before = kBeforeShaders,
              .groups = {options.groups, 1, 1},
              .constants = {{"kPrecision", options.precision}, {"kForm", std::uint32_t(options.form)}, {"kPass", which}},
              .writes = {"gnoClusterHeader", "gnoClusterMasks", "gnoClusterShade", "gnoClusterJobs"}};
    if (options.layers) pass.writes.push_back("gnoTransmittances");
    return pass;
}

}  // namespace cluster_passes

/// The hierarchy alone, over the view samples of one light. You: samples visible before.
inline PassList clusterHierarchyPasses(std::uint32_t width, std::uint32_t height, const ClusterOptions& options) {
    using namespace cluster_passes;
    const ClusterLayout layout = clusterLayout(width, height, options.form);
    const std::uint32_t words = clusterWordCount(layout), form = std::uint32_t(options.form);
    const bool compact = options.form == ClusterForm::compact;
    PassList passes{{.shader = "clusters/examples/reset.comp",
                     .part = "cluster_build",
                     .before = kBeforeShaders,
                     .groups = {std::min(1024u, groupsFor(words, 64)), 1, 1},
                     .constants = {{"kForm", form}},
                     .writes = {"gnoClusterHeader", "gnoClusterMasks", "gnoClusterShade"}},
                    {.shader = "clusters/examples/range.comp",
                     .part = "cluster_build",
                     .before = kBeforeShaders,
                     .groups = {groupsFor(width, 8), groupsFor(height, 8), 1},
                     .constants = {{"kForm", form}},
                     .writes = {"gnoClusterHeader"}},
                    {.shader = "clusters/examples/slices.comp",
                     .part = "cluster_build",
                     .before = kBeforeShaders,
                     .groups = {groupsFor(clusterSlices(layout) + 1, 64), 1, 1},
                     .constants = {{"kForm", form}},
                     .writes = {"gnoClusterHeader", "gnoClusterSliceTable"}}};
    appendClimb(passes, layout, compact || options.form == ClusterForm::implicitBounds ? kMasks : kMasks | kBounds);
    if (compact) {  // how many boxes there are, and where, is known by the masks
        passes.push_back({.shader = "clusters/examples/allocate.comp",
                          .part = "cluster_build",
                          .before = kBeforeShaders,
                          .groups = rowsOf64(words),
                          .constants = {{"kForm", form}},
                          .writes = {"gnoClusterHeader", "gnoClusterPointers"}});
        appendClimb(passes, layout, kBounds);
    }
    return passes;
}

/// Shadow volumes. With layers, the sums to zero before them: behind clusterHierarchyPasses, whose first pass has waited for who used them.
inline PassList clusterVolumePasses(std::uint32_t width, std::uint32_t height, std::uint32_t casters, const ClusterOptions& options) {
    PassList passes;
    if (options.layers)
        passes.push_back({.shader = "clusters/examples/clear_sums.comp",
                          .part = "cluster_setup",
                          .before = kBeforeNothing,
                          .groups = {groupsFor(width, 8), groupsFor(height, 8), 1},
                          .writes = {"gnoTransmittances"}});
    passes.push_back({.shader = "clusters/examples/volumes.comp",
                      .part = "cluster_setup",
                      .before = kBeforeShaders,
                      .groups = {groupsFor(casters, 64), 1, 1},
                      .constants = {{"kPrecision", options.precision}, {"kForm", std::uint32_t(options.form)}},
                      .writes = {"gnoClusterHeader", "gnoClusterVolumes", "gnoClusterInfo"}});
    return passes;
}

/// Every volume against the hierarchy, down to depth `split`.
inline PassList clusterExpandPasses(const ClusterOptions& options) { return {cluster_passes::traversal(options, 1)}; }

/// The jobs that were left, by as many groups as there are jobs or `groups`; empty without a split.
inline PassList clusterFinishPasses(const ClusterOptions& options) {
    if (options.split == 0) return {};
    Pass finish = cluster_passes::traversal(options, 2);
    finish.before = kBeforeShaders | kBeforeIndirect;
    finish.indirect = "gnoClusterHeader";
    finish.indirectOffset = kClusterGroupsAt;
    return {{.shader = "clusters/examples/finish_size.comp",
             .part = "cluster_finish",
             .before = kBeforeShaders,
             .groups = {1, 1, 1},
             .constants = {{"kForm", std::uint32_t(options.form)}, {"kGroups", options.groups}},
             .writes = {"gnoClusterHeader"}},
            finish};
}

/// All of them. You: casters, their states (core/caster_state.glsl), view samples and gnoClusterFrame visible before; with layers what casters let
/// through as well. At most 64 * 65,535 casters.
inline PassList clusterBuildPasses(std::uint32_t width, std::uint32_t height, std::uint32_t casters, const ClusterOptions& options) {
    PassList all = clusterHierarchyPasses(width, height, options);
    for (const PassList& more : {clusterVolumePasses(width, height, casters, options), clusterExpandPasses(options), clusterFinishPasses(options)})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// One answer per pixel. With layers it adds what stands in the way wholly to the sums, which hold what passes afterwards.
inline PassList clusterQueryPasses(std::uint32_t width, std::uint32_t height, const ClusterOptions& options) {
    Pass pass{.shader = options.layers ? "clusters/examples/merge_layers.comp" : "clusters/examples/merge.comp",
              .part = "cluster_merge",
              .before = kBeforeShaders,
              .groups = {groupsFor(width, 8), groupsFor(height, 8), 1},
              .constants = {{"kForm", std::uint32_t(options.form)}},
              .writes = {"gnoVisibility"}};
    if (options.layers) pass.writes.push_back("gnoTransmittances");
    return {pass};
}

}  // namespace gno
#endif
