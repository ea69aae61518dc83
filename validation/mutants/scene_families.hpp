// SPDX-License-Identifier: MIT
// Makers of tiny scenes, one scene a call: a family each, named in cases.cpp after what makes it hard.
#pragma once
#include "validation/mutants/scene_parts.hpp"

namespace gno::mutants {

// scenes_of_objects.cpp
TinyScene sharedEdges(Random& r);
TinyScene largeReceiver(Random& r);
TinyScene largeNearLight(Random& r);
TinyScene room(Random& r);
TinyScene sliversAtLight(Random& r);
TinyScene edgesAlongDirection(Random& r);
TinyScene stacks(Random& r);
TinyScene crossedSlivers(Random& r);
TinyScene latticeSoup(Random& r);
TinyScene anyExponent(Random& r);
TinyScene smallestUnits(Random& r);
TinyScene nested(Random& r);

// scenes_at_signs.cpp
TinyScene nearlyCoplanar(Random& r);
TinyScene touching(Random& r);
TinyScene besideLateralPlane(Random& r);
TinyScene besideBand(Random& r);
TinyScene touchingAtLight(Random& r);
TinyScene behindNearestPoint(Random& r);
TinyScene atRightAngle(Random& r);
TinyScene oneQuestion(Random& r);
TinyScene seam(Random& r);
TinyScene onOneCaster(Random& r);

}  // namespace gno::mutants
