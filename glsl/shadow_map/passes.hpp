// SPDX-License-Identifier: MIT
// gnomon shadow_map/passes.hpp : shadow maps on the host's side: arrays, passes and barriers, defaults (glsl/MODULES.md tells the story). C++20,
// standard library only (view.h needs GLM in C++; this does not include it).
//
// Per light: its views and one map. Per frame: shadowMapFitPasses; then you WAIT and read gnoShadowMapBounds (4 words a view, all 0: no sample in
// it), fit the views that hold samples (gnoShadowMapFit of view.h), write them to gnoShadowMapViews, and record shadowMapBuildPasses. Whoever takes
// views that do not follow the samples leaves fit and wait out: all views of the light are drawn then. The map is an image of yours, gnoShadowMap:
// D32, `size` x `size` texels, one layer per view, in the general layout for these lists.
#ifndef GNO_SHADOW_MAP_PASSES_HPP
#define GNO_SHADOW_MAP_PASSES_HPP
#include "../core/pass.hpp"

namespace gno {

struct ShadowMapOptions {
    std::uint32_t size = 2048;  ///< texels along a side, of each view
    float slopeBias = 1;        ///< texels; draw with a depthBiasSlopeFactor of MINUS this, constant factor and clamp 0
    float constantBias = 1;     ///< texels; for gnoShadowMapConstantBias of view.h when you write the fitted views
    std::uint32_t faces = 0;    ///< GNO_SHADOW_MAP_BOTH, GNO_SHADOW_MAP_BACK or GNO_SHADOW_MAP_FRONT
};

/// The most views a light has: six faces of a cube, and a spot light's cone before them. A light at infinity has one.
inline constexpr std::uint32_t kShadowMapMostViews = 7;

/// Bytes of header and views.
constexpr std::uint64_t shadowMapViewBytes(std::uint64_t views) { return 16 + 80 * views; }

/// GNO_SHADOW_MAP_SET's arrays for a light with `views` views.
inline ArrayList shadowMapArrays(std::uint64_t views) {
    return {// You write it when the light changes: everything that it sees, not fitted to anything.
            {"gnoShadowMapWholeViews", 1, 0, "GnoShadowMapHeader, GnoShadowMapView[views]", shadowMapViewBytes(views), kUsageStorage, First::host,
             Kept::forBuild},
            {"gnoShadowMapBounds", 1, 1, "uint[4 views]", 16 * views, kUsageStorage, First::anything, Kept::forBuild},
            // You write it each frame, between the two lists: the views that are drawn.
            {"gnoShadowMapViews", 1, 0, "GnoShadowMapHeader, GnoShadowMapView[views]", shadowMapViewBytes(views), kUsageStorage, First::host}};
}

/// Which views hold view samples, and where in them. You: samples visible before.
inline PassList shadowMapFitPasses(std::uint32_t width, std::uint32_t height) {
    return {{.shader = "shadow_map/examples/reset.comp", .part = "shadow_map_setup", .writes = {"gnoShadowMapBounds"}},
            {.shader = "shadow_map/examples/fit.comp",
             .part = "shadow_map_setup",
             .groups = {groupsFor(width, 8), groupsFor(height, 8), 1},
             .writes = {"gnoShadowMapBounds"},
             .renamed = {{"gnoShadowMapViews", "gnoShadowMapWholeViews"}}}};
}

/// The map of all casters that are kept, for `views` views in gnoShadowMapViews. You: casters and states (core/caster_state.glsl) visible before.
inline PassList shadowMapBuildPasses(std::uint32_t casters, std::uint32_t views, const ShadowMapOptions& options) {
    PassList passes;
    for (std::uint32_t view = 0; view < views; ++view)
        passes.push_back({.shader = "shadow_map/examples/depth.vert",
                          .part = "shadow_map_build",
                          .before = view == 0 ? kBeforeShaders : kBeforeNothing,  // a layer of its own each
                          .groups = {3 * casters, 1, 1},
                          .number = view,
                          .constants = {{"kFaces", options.faces}},
                          .writes = {"gnoShadowMap"},
                          .kind = PassKind::depth});
    return passes;
}

/// One answer per pixel of width x height view samples.
inline PassList shadowMapQueryPasses(std::uint32_t width, std::uint32_t height, bool fragment) {
    return {{.shader = fragment ? "shadow_map/examples/query.frag" : "shadow_map/examples/query.comp",
             .part = "shadow_map_query",
             .before = fragment ? kBeforeShaders | kBeforeDepth : std::uint32_t(kBeforeDepth),  // a colour target that the frame before drew, too
             .groups = {groupsFor(width, 8), groupsFor(height, 8), 1},
             .writes = {"gnoVisibility"},
             .kind = fragment ? PassKind::fullscreen : PassKind::compute}};
}

}  // namespace gno
#endif
