// SPDX-License-Identifier: MIT
// Per-triangle shadow volumes against a hierarchy of view samples: `ptsv` (2014, clusters) and `ptsv-2011` (tiles with their depth range).
#pragma once
#include <memory>

#include "host_min/techniques/technique.hpp"

namespace gno::host {

/// `flat`: the two-dimensional hierarchy of 2011.
std::unique_ptr<Technique> makeClusterTechnique(bool flat);

}  // namespace gno::host
