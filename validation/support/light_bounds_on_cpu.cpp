// SPDX-License-Identifier: MIT
// One variant: GNO_LIGHT_BOUNDS_VARIANT is its name. A variant of other text finds it first on its include path (-iquote).
// Everything is in an unnamed namespace, so that one program can hold many.
#include "validation/support/light_bounds_on_cpu.hpp"

#include "validation/support/glsl_as_cpp.hpp"

#ifndef GNO_LIGHT_BOUNDS_VARIANT
#error "define GNO_LIGHT_BOUNDS_VARIANT, a name"
#endif

#pragma GCC diagnostic ignored "-Wunused-function"

namespace gno {
namespace {

#undef GNO_NAMESPACE_BEGIN
#undef GNO_NAMESPACE_END
#define GNO_NAMESPACE_BEGIN
#define GNO_NAMESPACE_END
#include "glsl/rivals/light_bvh_bounds.glsl"

std::string lost(vec4 light, const GnoForestGrid& grid, const GnoCaster& caster, int facing, vec3 p) {
    const vec3 q = gnoFromLight(light, p);
    const uvec3 at = gnoCellAt(light, grid, q);
    const GnoLightBvhCaster seen = gnoLightBvhCaster(light, caster, facing);
    if ((gnoLightBvhFaces(light, grid, seen) & (1u << at.z)) == 0u) return "no reference on the sample's face";
    uint low = 0, high = 0;
    if (!gnoLightBvhBounds(light, grid, at.z, seen, low, high)) return "no cells on the sample's face";
    if (!gnoLightBvhHolds(low, high, at.x | (at.y << 16))) return "the sample's cell is not in the bounds";
    return gnoTopLeastDepth(light, caster) <= gnoLightDepth(light, q) ? "" : "the caster is said to be farther than the sample";
}

[[maybe_unused]] const bool kRegistered = (cpu::lightBoundsVariants().push_back({GNO_LIGHT_BOUNDS_VARIANT, lost}), true);

}  // namespace
}  // namespace gno
