// SPDX-License-Identifier: MIT
// gnomon core/passes.hpp : what every technique works on, casters, their states and view samples, on the host's side. C++20, standard library only.
//
// Yours per frame: gnoCasters when geometry moved, states when geometry or light changed, view samples when anything did.
// Images of the examples are no arrays; their numbers are of set 2: gnoSamples 2 (rgba32ui), gnoVisibility 3 (r32ui), gnoCounts 4 (rgba32ui),
// gnoPositions 12 (rgba32f), gnoPrimitives 13 (r32ui), all in VK_IMAGE_LAYOUT_GENERAL.
#ifndef GNO_CORE_PASSES_HPP
#define GNO_CORE_PASSES_HPP
#include "pass.hpp"

namespace gno {

/// `casters` triangles.
inline ArrayList casterArrays(std::uint64_t casters) {
    const std::uint64_t n = casters > 0 ? casters : 1;
    return {
        {"gnoCasters", 0, 0, "float[9 casters]: three vertices on the grid", 36 * n, kUsageStorage, First::host},
        {"gnoStates", 2, 0, "uint[casters]: gnoCasterState", 4 * n},
        {"gnoClosed", 2, 10, "a bit per caster: of a closed, consistently oriented, opaque mesh", 4 * ((n + 31) / 32), kUsageStorage, First::host},
        {"gnoCullPlanes", 2, 11, "vec4[16]: planes of the hull of frustum and light, with GNO_CULL_HULL", 256, kUsageUniform, First::host}};
}

/// Facing and culling of each caster, exact. Once per light, and when casters moved.
inline PassList casterStatePasses(std::uint32_t casters) {
    return {{.shader = "core/examples/caster_state.comp",
             .part = "caster_setup",
             .before = kBeforeShaders,
             .groups = {groupsFor(casters, 64), 1, 1},
             .writes = {"gnoStates"}}};
}

/// View samples of a G-buffer (positions, primitive ids) for one light.
inline PassList viewSamplePasses(std::uint32_t width, std::uint32_t height) {
    return {{.shader = "core/examples/view_samples.comp",
             .part = "view_samples",
             .before = kBeforeShaders,
             .groups = {groupsFor(width, 8), groupsFor(height, 8), 1},
             .writes = {"gnoSamples"}}};
}

}  // namespace gno
#endif
