// SPDX-License-Identifier: MIT
// Technique light-grid: lists of casters per cell of the light's grid, in order of depth; a rival of the trees.
#pragma once
#include <memory>

#include "host_min/techniques/technique.hpp"

namespace gno::host {

std::unique_ptr<Technique> makeLightGridTechnique();

}  // namespace gno::host
