// SPDX-License-Identifier: MIT
#pragma once
#include "scenes/generator/draft.hpp"

namespace gno::scenes {

/// A tree around the origin, y up, of about `triangles` (at least 300), most of them leaves. Closed: trunk, branches and every leaf are solids.
Model makeTree(uint32_t bark, uint32_t leaf, double height, size_t triangles, Random& random);

}  // namespace gno::scenes
