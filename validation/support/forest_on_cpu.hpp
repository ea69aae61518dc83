// SPDX-License-Identifier: MIT
// The forest on the CPU, in one thread, made of the same GLSL text that the device runs: cells, assignment, build, and all four queries.
//
// A variant is one compilation of forest_on_cpu.cpp, as with the TOP tree (top_on_cpu.hpp): the text as it stands ("plain"), or with a fault put in
// on purpose (validation/mutants). A program sees the variants that it is linked with.
#pragma once
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "glsl/forest/cells.h"
#include "validation/support/top_on_cpu.hpp"

namespace gno::cpu {

/// What glsl/forest knows of a caster, whole and for one cell.
struct CasterCells {
    std::vector<uvec4> rectangles;  ///< per face: columns x .. z-1, rows y .. w-1; none on faces that the caster is said not to meet
    float least = 0, most = 0;      ///< bounds of gnoLightDepth
    std::function<bool(uint face, uvec2 at)> missed, covered;  ///< valid until the next call of the same forest
};

struct ForestChoice {
    uint precision = GNO_PRECISION_CERTIFIED;
    bool viewCull = true, cover = true;
    uint seed = 1;                ///< of the insertion order
    uint capacity = 0xFFFFFFFFu;  ///< pairs the pool holds; more than are counted: as many as are counted
};

class Forest {
public:
    virtual ~Forest() = default;

    [[nodiscard]] virtual uint cellOf(vec4 light, const GnoForestGrid& grid, vec3 p) const = 0;
    [[nodiscard]] virtual float depth(vec4 light, vec3 p) const = 0;  ///< gnoLightDepth
    [[nodiscard]] virtual int facing(vec4 light, const GnoCaster& caster) const = 0;
    /// facing is not 0.
    [[nodiscard]] virtual CasterCells cellsOf(vec4 light, const GnoForestGrid& grid, const GnoCaster& caster) const = 0;

    /// All passes of the examples, one after the other. Throws std::runtime_error when one leaves its arrays or does not end.
    virtual void build(std::span<const GnoCaster> casters, vec4 light, const GnoForestGrid& grid, std::span<const GnoViewSample> samples,
                       const ForestChoice& choice) = 0;
    virtual TopAnswer ask(TopQuery query, const GnoViewSample& sample) = 0;

    [[nodiscard]] virtual const GnoForestHeader& header() const = 0;
    [[nodiscard]] virtual const std::vector<GnoForestCell>& cells() const = 0;
    [[nodiscard]] virtual const std::vector<GnoForestPair>& pairs() const = 0;  ///< one that was never written is {GNO_FOREST_NONE, GNO_FOREST_NONE}
};

struct ForestVariant {
    std::string name;
    std::unique_ptr<Forest> (*make)();
};

/// All variants that this program is linked with. Each has one state: use one forest of a variant at a time.
inline std::vector<ForestVariant>& forestVariants() {
    static std::vector<ForestVariant> variants;
    return variants;
}

}  // namespace gno::cpu
