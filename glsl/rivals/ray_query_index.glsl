// SPDX-License-Identifier: MIT
// gnomon rivals/ray_query_index.glsl : indices for a bottom-level acceleration structure in which only the kept casters can be met.
//
//   uvec3 gnoRayQueryIndices(uint caster, int facing)      the caster's three vertices; the first one three times when facing is 0
//
// By the Vulkan specification a triangle that is a point generates no intersection, and one with the same index twice can always be discarded from
// the structure. So the casters' own buffer serves as vertices, a caster's index is its primitive index whatever is culled, and the host needs no
// count back. (A NaN would mark a triangle as inactive, too, but lavapipe 25.0 loses other triangles then.)
//
// Space      vertices at 3 caster, 3 caster + 1, 3 caster + 2 (core/bindings.glsl); facing of gnoCasterFacing (core/caster_state.glsl): 0 for a
//            caster
//            that is culled or seen edge-on
// Stages     any; pure
// Requires   #version 450, no extension
#ifndef GNO_RIVALS_RAY_QUERY_INDEX_GLSL
#define GNO_RIVALS_RAY_QUERY_INDEX_GLSL
#include "../core/shared_types.h"

uvec3 gnoRayQueryIndices(uint caster_, int facing_) {
    uint first_ = 3u * caster_;
    return facing_ == 0 ? uvec3(first_) : uvec3(first_, first_ + 1u, first_ + 2u);
}
#endif
