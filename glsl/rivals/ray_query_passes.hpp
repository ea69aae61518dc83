// SPDX-License-Identifier: MIT
// gnomon rivals/ray_query_passes.hpp : the device's own ray queries on the host's side: arrays, passes and barriers (glsl/MODULES.md tells the
// story). C++20, standard library only.
//
// Per light: indices and two acceleration structures, which the driver sizes (vkGetAccelerationStructureBuildSizesKHR): kRayBottomLevel over the
// casters' own buffer as vertices (3 casters of them, packed floats) and gnoRayIndices, 32 bits each, one primitive per caster; kRayTopLevel, bound
// as gnoRayStructure, with one untransformed instance of it. Per frame: all build passes again when casters, their states or the light changed.
#ifndef GNO_RIVALS_RAY_QUERY_PASSES_HPP
#define GNO_RIVALS_RAY_QUERY_PASSES_HPP
#include "../core/pass.hpp"

namespace gno {

/// What you record for the passes of PassKind::command: vkCmdBuildAccelerationStructuresKHR, anew, not updated.
inline constexpr std::string_view kRayBottomLevel = "build the bottom level", kRayTopLevel = "build the top level";

inline ArrayList rayQueryArrays(std::uint64_t casters) {
    const std::uint64_t n = casters > 0 ? casters : 1;
    return {{"gnoRayIndices", 2, 7, "uint[3 casters]", 12 * n, kUsageStorage | kUsageRayInput, First::anything, Kept::forBuild}};
}

/// Both structures. You: casters and states (core/caster_state.glsl) visible before, the casters to builds of acceleration structures as well.
inline PassList rayQueryBuildPasses(std::uint32_t casters) {
    return {{.shader = "rivals/examples/ray_set_up.comp",
             .part = "ray_setup",
             .before = kBeforeRays,  // the frame before may still read the indices
             .groups = {groupsFor(casters, 64), 1, 1},
             .writes = {"gnoRayIndices"}},
            {.shader = kRayBottomLevel,
             .part = "bottom_build",
             .before = kBeforeShaders,  // indices; queries of the frame before, which have waited for its builds
             .kind = PassKind::command},
            {.shader = kRayTopLevel, .part = "top_level_build", .before = kBeforeRays, .writes = {"gnoRayStructure"}, .kind = PassKind::command}};
}

/// One answer per pixel of width x height view samples.
inline PassList rayQueryPasses(std::uint32_t width, std::uint32_t height, bool fragment) {
    return {{.shader = fragment ? "rivals/examples/ray_query.frag" : "rivals/examples/ray_query.comp",
             .part = "ray_query",
             .before = fragment ? kBeforeShaders | kBeforeRays : std::uint32_t(kBeforeRays),  // a colour target that the frame before drew, too
             .groups = {groupsFor(width, 8), groupsFor(height, 8), 1},
             .writes = {"gnoVisibility"},
             .kind = fragment ? PassKind::fullscreen : PassKind::compute}};
}

}  // namespace gno
#endif
