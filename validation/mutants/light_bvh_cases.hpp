// SPDX-License-Identifier: MIT
// What the light-space hierarchy is asked on the CPU. Each function says in one line what is wrong, or nothing.
#pragma once
#include "validation/support/device_test.hpp"
#include "validation/support/light_bvh_on_cpu.hpp"

namespace gno::mutants {

struct LightBvhCase {
    std::string name;
    test::Scene scene;
    GnoForestGrid grid{};
    std::vector<GnoCaster> casters{};
    std::vector<uint8_t> want{};  ///< by the definition in integers
    uint references = ~0u;        ///< ~0: not known
};

/// Casters of any number, the same one many times, all edge-on, around the light; a smaller one after a larger one.
std::vector<LightBvhCase> makeLightBvhCases();

/// The hierarchy is sound (support/light_bvh_walk.hpp), and all queries answer as the definition does. Both orders of invocations.
std::string wrongTree(cpu::LightBvh& tree, const LightBvhCase& c);

/// A pool that is too small is not overrun, the header tells how many references there are, and queries that they do not know.
std::string wrongPool(cpu::LightBvh& tree, const LightBvhCase& c);

/// Nodes and casters that a query visits, on average: no more than the text as it stands needs, and a little.
struct LightBvhCost {
    double stack = 0, stackless = 0;
};
LightBvhCost costOf(cpu::LightBvh& tree, const LightBvhCase& c);

/// No caster is lost for a sample that it shadows, by the definition in integers. `shadows` counts the pairs of caster and shadowed sample.
std::string wrongBounds(const cpu::LightBvh& tree, uint64_t& shadows);

}  // namespace gno::mutants
