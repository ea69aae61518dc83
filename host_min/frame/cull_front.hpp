// SPDX-License-Identifier: MIT
// For which meshes may front-face culling drop what faces the light? Only where no view sample's answer changes.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "host_min/scene/scene.hpp"

namespace gno::host {

struct FrontCull {
    std::vector<uint8_t> mayLose;  ///< one per triangle: 1 = it may go when it faces the light
    std::string leftWhole;         ///< one line: how many meshes with closed parts keep all, and why; empty when none does
};

/// The argument of scene/weld.cpp holds for view samples with winding number 0. A camera sees only such of a mesh's closed parts when
///   - all of their triangles are opaque: through a hole or a glass it would see the inside;
///   - the near plane's rectangle, where every ray of view begins, lies outside: none of their triangles crosses it, and the winding number at its
///     middle is 0.
/// Judged per mesh instance; where one of the two does not hold, the mesh keeps all of its triangles. Lights need not be asked: weld.cpp. What a
/// rasteriser's rounding puts on the other side of a surface of *another* mesh is not covered: the oracle, which sees all casters, counts it.
FrontCull legalFrontCull(const Frame& frame, double aspect);

}  // namespace gno::host
