// SPDX-License-Identifier: MIT
// Technique light-bvh: a bounding volume hierarchy in the light's own coordinates, a rival of the trees.
#pragma once
#include <memory>

#include "host_min/techniques/technique.hpp"

namespace gno::host {

std::unique_ptr<Technique> makeLightBvhTechnique();

}  // namespace gno::host
