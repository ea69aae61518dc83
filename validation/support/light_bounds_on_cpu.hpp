// SPDX-License-Identifier: MIT
// Bounds of casters in a light's cells (forest/cells.glsl, rivals/light_bvh_bounds.glsl) on the CPU, made of the same GLSL text that the device
// runs. A variant is one compilation of light_bounds_on_cpu.cpp: the text as it stands ("plain"), or with a fault put in on purpose
// (validation/mutants).
#pragma once
#include <string>
#include <vector>

#include "glsl/core/shared_types.h"
#include "glsl/forest/cells.h"

namespace gno::cpu {

struct LightBoundsVariant {
    std::string name;
    /// Could a hierarchy lose this caster for a view sample at p? Empty: it could not; else why.
    std::string (*lost)(vec4 light, const GnoForestGrid& grid, const GnoCaster& caster, int facing, vec3 p);
};

/// All variants that this program is linked with.
inline std::vector<LightBoundsVariant>& lightBoundsVariants() {
    static std::vector<LightBoundsVariant> variants;
    return variants;
}

}  // namespace gno::cpu
