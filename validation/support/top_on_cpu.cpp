// SPDX-License-Identifier: MIT
// One variant: GNO_TOP_VARIANT is its name. A variant of other text finds it first on its include path (-iquote).
// Everything is in an unnamed namespace, so that one program can hold many.
#include "validation/support/top_on_cpu.hpp"

#ifndef GNO_TOP_VARIANT
#error "define GNO_TOP_VARIANT, a name"
#endif
#ifndef GNO_TOP_STACK_SIZE
#define GNO_TOP_STACK_SIZE 32
#endif
#ifndef GNO_TOP_SHORT_STACK_SIZE
#define GNO_TOP_SHORT_STACK_SIZE 12
#endif
#define GNO_ON_CPU_TREES 1
#define GNO_ON_CPU_CELLS 0
#include "validation/support/trees_on_cpu.hpp"

namespace gno {
namespace {

class Tree final : public cpu::TopTree {
public:
    void build(std::span<const GnoCaster> casters, vec4 light, uint precision, std::span<const uint> order) override {
        state.casters.assign(casters.begin(), casters.end());
        state.light = light;
        state.precision = precision;
        buildTrees(uint(casters.size()), order, gnoState(precision));
    }
    cpu::TopAnswer ask(cpu::TopQuery query, const GnoViewSample& sample) override { return askTrees(query, sample); }

    [[nodiscard]] const std::vector<vec4>& planes() const override { return state.planes; }
    [[nodiscard]] const std::vector<GnoTopLink>& links() const override { return state.links; }
    [[nodiscard]] const GnoTopHeader& header() const override { return state.header; }
    [[nodiscard]] bool decide(vec4 light, const GnoCaster& caster, vec3 p, uint precision) const override {
        return gnoDecideInShadow(light, caster, p, precision);
    }
    [[nodiscard]] int facing(vec4 light, const GnoCaster& caster) const override { return gnoFacing(light, caster); }
};

[[maybe_unused]] const bool kRegistered =
    (cpu::topVariants().push_back({GNO_TOP_VARIANT, [] { return std::unique_ptr<cpu::TopTree>(std::make_unique<Tree>()); }}), true);

}  // namespace
}  // namespace gno
