// SPDX-License-Identifier: MIT
// The convex hull of view frustum and light as planes: what lies outside of one of them shadows nothing that the camera sees.
#pragma once
#include <vector>

#include <glm/glm.hpp>

#include "host_min/scene/scene.hpp"

namespace gno::host {

inline constexpr size_t kMaxCullPlanes = 16;  ///< of caster_state.comp

/// Planes with the hull on their positive side, at most kMaxCullPlanes, on the grid. dot(xyz, p) + w < 0 in fp32 means certainly outside: each is
/// pushed outward by far more than rounding and the samples' own offset take. A plane that cannot be trusted is left out, which only culls less.
/// After Mora et al., EGSR 2016, section 4 ("frustum culling").
std::vector<glm::vec4> cullHull(const Camera& camera, double aspect, glm::vec4 light);

}  // namespace gno::host
