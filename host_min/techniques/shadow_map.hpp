// SPDX-License-Identifier: MIT
// Shadow maps: one view for a directional light, six faces for a point light, a cone's view and six faces for a spot; those that hold view samples.
#pragma once
#include <memory>

#include "host_min/techniques/technique.hpp"

namespace gno::host {

std::unique_ptr<Technique> makeShadowMapTechnique();

}  // namespace gno::host
