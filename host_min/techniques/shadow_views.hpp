// SPDX-License-Identifier: MIT
// The views of a shadow map before and after they are fitted to the view samples; pure functions.
#pragma once
#include <span>
#include <vector>

#include "glsl/shadow_map/view.h"
#include "host_min/scene/scene.hpp"

namespace gno::host {

/// A pyramid (perspective, its tip in the light) or a prism along `forward`; `rect` as in glsl/shadow_map/view.h.
struct ShadowFrustum {
    glm::vec3 right, down, forward;
    glm::vec4 rect;
    bool perspective = true;
    float near = 0, far = 1;  ///< along `forward`, of a prism: from the caster nearest to the light to the farthest one

    [[nodiscard]] GnoShadowMapView view() const;
};

/// Everything the light sees: the prism that holds every position of the grid; six faces of a cube; for a spot light whose cone opens to 75 degrees
/// at most that cone's pyramid before them. The first one that holds a sample answers for it; together they hold every position but the light's own.
std::vector<ShadowFrustum> shadowFrusta(const Frame& frame, glm::vec4 light);

/// Of `frusta` those that hold samples: `measured` is what glsl/shadow_map/fit.glsl wrote. focused: cut down to the samples; otherwise pyramids stay
/// whole, and a prism is cut down to the casters.
std::vector<ShadowFrustum> fitShadowFrusta(std::span<const ShadowFrustum> frusta, std::span<const uint32_t> measured,
                                           std::span<const Triangle> casters, bool focused);

}  // namespace gno::host
