// SPDX-License-Identifier: MIT
// The light grid on the CPU, in one thread, made of the same GLSL text that the device runs: assignment, sub cells, lists, and the query.
//
// A variant is one compilation of light_grid_on_cpu.cpp, as with the TOP tree (top_on_cpu.hpp). Lists are sorted by the part that one invocation
// does alone.
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "glsl/forest/cells.h"
#include "glsl/rivals/light_grid.h"

namespace gno::cpu {

class LightGrid {
public:
    virtual ~LightGrid() = default;

    /// All passes of the examples, one after the other. Throws std::runtime_error when one leaves its arrays.
    virtual void build(std::span<const GnoCaster> casters, vec4 light, const GnoForestGrid& grid, std::span<const GnoViewSample> samples,
                       uint nest) = 0;
    /// With the casters' planes, or from their vertices alone.
    [[nodiscard]] virtual bool ask(const GnoViewSample& sample, bool planes) = 0;
    [[nodiscard]] virtual const GnoLightGridHeader& header() const = 0;
};

struct LightGridVariant {
    std::string name;
    std::unique_ptr<LightGrid> (*make)();
};

/// All variants that this program is linked with. Each has one state: use one grid of a variant at a time.
inline std::vector<LightGridVariant>& lightGridVariants() {
    static std::vector<LightGridVariant> variants;
    return variants;
}

}  // namespace gno::cpu
