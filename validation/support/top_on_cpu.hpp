// SPDX-License-Identifier: MIT
// The TOP tree on the CPU, in one thread, made of the same GLSL text that the device runs: build, and all four queries.
//
// A variant is one compilation of top_on_cpu.cpp: the text as it stands, with stacks as large as the device's ("plain") or so short that they
// overflow ("short stacks"), or with a fault put in on purpose (validation/mutants). A program sees the variants that it is linked with.
#pragma once
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "glsl/core/shared_types.h"
#include "glsl/top/node.h"

namespace gno::cpu {

enum class TopQuery { psv, dPsv, dStackless, dHybrid };
inline constexpr std::array kTopQueries{TopQuery::psv, TopQuery::dPsv, TopQuery::dStackless, TopQuery::dHybrid};
inline constexpr std::array<const char*, 4> kTopQueryNames{"psv", "d-psv", "d-stackless", "d-hybrid"};

struct TopAnswer {
    uint visibility = GNO_VISIBILITY_UNKNOWN;
    bool inShadow = false;  ///< visibility is GNO_VISIBILITY_SHADOW
    uint visitedNodes = 0;
    uint deepestStack = 0;
    uint stackOverflows = 0;
};

class TopTree {
public:
    virtual ~TopTree() = default;

    /// Sets up all casters and inserts them in this order (caster indices). All positions lie on the scene grid. Casters that are edge-on
    /// to the light are left out, as on the device.
    virtual void build(std::span<const GnoCaster> casters, vec4 light, uint precision, std::span<const uint> order) = 0;

    /// Throws std::runtime_error when a query leaves its arrays or does not end; a build likewise.
    virtual TopAnswer ask(TopQuery query, const GnoViewSample& sample) = 0;

    [[nodiscard]] virtual const std::vector<vec4>& planes() const = 0;
    [[nodiscard]] virtual const std::vector<GnoTopLink>& links() const = 0;
    [[nodiscard]] virtual const GnoTopHeader& header() const = 0;

    /// core/decide.glsl and core/orient3d.glsl of this variant, without a tree.
    [[nodiscard]] virtual bool decide(vec4 light, const GnoCaster& caster, vec3 p, uint precision) const = 0;
    [[nodiscard]] virtual int facing(vec4 light, const GnoCaster& caster) const = 0;
};

/// The order in which a device with one invocation at a time inserts: gnoPermute(0 .. count - 1, count, seed).
std::vector<uint> insertionOrder(uint count, uint seed);

struct TopVariant {
    std::string name;
    std::unique_ptr<TopTree> (*make)();
};

/// All variants that this program is linked with. Each has one state: use one tree of a variant at a time.
inline std::vector<TopVariant>& topVariants() {
    static std::vector<TopVariant> variants;
    return variants;
}

/// Throws std::runtime_error when the program is not linked with it.
std::unique_ptr<TopTree> makeTopTree(const std::string& variant);

}  // namespace gno::cpu
