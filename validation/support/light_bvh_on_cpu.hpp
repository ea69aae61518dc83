// SPDX-License-Identifier: MIT
// The light-space hierarchy of rivals/ on the CPU, made of the same GLSL text that the device runs: bounds of casters in a light's cells, the build
// (the sort between its steps is the standard library's), and both queries. A variant is one compilation of light_bvh_on_cpu.cpp, as with the TOP
// tree (top_on_cpu.hpp).
#pragma once
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "glsl/core/shared_types.h"
#include "glsl/forest/cells.h"

namespace gno::cpu {

/// GnoLightBvhNode of glsl/rivals/light_bvh.h, which each variant has of its own.
struct LightBvhNode {
    uvec4 low, high;
    vec4 least;
    uvec4 link;
};

struct LightBvhAnswer {
    uint visibility = GNO_VISIBILITY_UNKNOWN;
    uint visitedNodes = 0, deepestStack = 0, stackOverflows = 0;
};

enum class LightBvhQuery { stack, shortStack, stackless };  ///< 32 entries, one entry
inline constexpr std::array kLightBvhQueries{LightBvhQuery::stack, LightBvhQuery::shortStack, LightBvhQuery::stackless};

class LightBvh {
public:
    virtual ~LightBvh() = default;

    /// All passes of the examples, one after the other, over what the build before left. capacity 0: as many references as are needed. Invocations
    /// run from the first to the last, or backwards. Throws std::runtime_error when a pass leaves its arrays.
    virtual void build(std::span<const GnoCaster> casters, vec4 light, const GnoForestGrid& grid, uint capacity, bool backwards) = 0;
    /// Throws std::runtime_error when the query leaves its arrays or does not end.
    [[nodiscard]] virtual LightBvhAnswer ask(LightBvhQuery query, const GnoViewSample& sample) = 0;

    [[nodiscard]] virtual uint references() const = 0;  ///< as the header says
    [[nodiscard]] virtual std::array<uint, 6> roots() const = 0;
    [[nodiscard]] virtual std::vector<LightBvhNode> nodes() const = 0;
    [[nodiscard]] virtual const std::vector<uint>& parents() const = 0;

    /// Could a hierarchy lose this caster for a view sample at p? Empty: it could not; else why.
    [[nodiscard]] virtual std::string lost(vec4 light, const GnoForestGrid& grid, const GnoCaster& caster, int facing, vec3 p) const = 0;
};

struct LightBvhVariant {
    std::string name;
    std::unique_ptr<LightBvh> (*make)();
};

/// All variants that this program is linked with. Each has one state: use one hierarchy of a variant at a time.
inline std::vector<LightBvhVariant>& lightBvhVariants() {
    static std::vector<LightBvhVariant> variants;
    return variants;
}

}  // namespace gno::cpu
