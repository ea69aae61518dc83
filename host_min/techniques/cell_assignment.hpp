// SPDX-License-Identifier: MIT
// The light's grid of cells on the host's side: what a forest of trees and a grid of lists begin with (lightCell... of glsl/forest/passes.hpp).
#pragma once
#include <glm/glm.hpp>

#include "glsl/forest/cells.h"
#include "glsl/forest/passes.hpp"
#include "host_min/frame/inputs.hpp"
#include "host_min/techniques/structure.hpp"

namespace gno::host {

/// The contract's grid for a light: six faces around a point, or one face that holds the box from `low` to `high` (casters) and all samples.
GnoForestGrid forestGrid(glm::vec4 light, glm::vec3 low, glm::vec3 high, uint32_t resolution);

/// Which limit of the device a frame's triangles would pass, and what to do; empty: none.
std::string lightCellsOverLimit(const DeviceFacts& device, const FrameLoad& load);

/// Of a frame's light. Throws LimitError when there are too many triangles.
LightCells lightCells(const FrameInputs& inputs, uint32_t resolution, bool viewCull, bool cover);

/// gnoForestGrid for these cells.
void writeGrid(Buffer& grid, const FrameInputs& inputs, const LightCells& cells);

}  // namespace gno::host
