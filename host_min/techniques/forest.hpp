// SPDX-License-Identifier: MIT
// Technique forest: a cube map (point light) or a grid (directional light) of small TOP trees.
#pragma once
#include <memory>

#include "host_min/techniques/technique.hpp"

namespace gno::host {

std::unique_ptr<Technique> makeForestTechnique();

}  // namespace gno::host
