// SPDX-License-Identifier: MIT
// The samples where a technique and the exact oracle differ, each with the caster it turned on and that caster's plane that lies nearest to it.
#pragma once
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "viz/scene_mesh.hpp"

namespace gno::viz {

struct WrongSample {
    glm::uvec2 pixel{0};
    glm::vec3 position{0};  ///< on the grid
    uint32_t own = 0;       ///< caster it lies on
    bool isLeak = false;    ///< lit, and should be in shadow; else the other way round
    /// A leak: a caster that shadows it, as the oracle says. False dark: of all casters the one whose shadow volume is nearest.
    uint32_t caster = 0;
    uint32_t plane = 0;   ///< 0..2 lateral (ab, bc, ca), 3 the caster's own
    double distance = 0;  ///< to that plane, metres; negative inside the volume
};

struct WrongSamples {
    std::vector<WrongSample> samples;                         ///< at most as many as were asked for: leaks first
    uint64_t checked = 0, wrong = 0, leaks = 0, unknown = 0;  ///< unknown: wrong ones that have no answer
};

/// Throws InputError: the dump has no oracle's answers, or they are not those that its record counted.
WrongSamples wrongSamplesOf(const Dump& dump, std::span<const Corners> corners, size_t limit);

}  // namespace gno::viz
