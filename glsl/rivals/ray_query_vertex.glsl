// SPDX-License-Identifier: MIT
// gnomon rivals/ray_query_vertex.glsl : vertices for a bottom-level acceleration structure that holds the kept casters only.
//
//   uvec3 gnoRayQueryVertex(vec3 vertex, int facing)      the bits of a vertex (VK_FORMAT_R32G32B32_SFLOAT); NaN when facing is 0
//
// Vulkan calls a triangle with a NaN in the x of a vertex inactive: no ray meets it, and the primitive indices of the others stay what they were, so a caster's index
// is its primitive index whatever is culled, and the host needs no count back. Bits and not floats, because a shader may change a NaN that it computes with.
//
// Space      the vertex on the scene grid; facing of gnoCasterFacing (core/caster_state.glsl): 0 for a caster that is culled or seen edge-on
// Stages     any; pure
// Requires   #version 450, no extension
#ifndef GNO_RIVALS_RAY_QUERY_VERTEX_GLSL
#define GNO_RIVALS_RAY_QUERY_VERTEX_GLSL
#include "../core/shared_types.h"

uvec3 gnoRayQueryVertex(vec3 vertex_, int facing_) { return facing_ == 0 ? uvec3(0x7FC00000u) : floatBitsToUint(vertex_); }
#endif
