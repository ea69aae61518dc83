// SPDX-License-Identifier: MIT
// gnomon-light-bvh-mutants [NAME...]: the text of bounds in a light's cells and of the light-space hierarchy, on the CPU: light_bvh_cases.hpp. What
// is printed: run.hpp.
#include <fmt/format.h>

#include "validation/mutants/light_bvh_cases.hpp"
#include "validation/mutants/run.hpp"

int main(int argc, char** argv) {
    using namespace gno;
    const std::vector<mutants::LightBvhCase> cases = mutants::makeLightBvhCases();
    return mutants::run({argv + 1, argv + argc}, cpu::lightBvhVariants(), [&](const cpu::LightBvhVariant& variant, bool mutant) -> mutants::Verdict {
        const auto tree = variant.make();
        for (const mutants::LightBvhCase& c : cases) {
            const std::string wrong = mutants::wrongTree(*tree, c);
            if (!wrong.empty()) return {wrong};
        }
        std::string costs;
        for (const mutants::LightBvhCase& c : cases) {
            if (c.casters.size() != 300) continue;
            const std::string wrong = mutants::wrongPool(*tree, c);
            if (!wrong.empty()) return {wrong};
            const mutants::LightBvhCost cost = mutants::costOf(*tree, c);
            costs += fmt::format("{:.3f} and {:.3f} nodes a sample; ", cost.stack, cost.stackless);
        }
        uint64_t shadows = 0;
        const std::string wrong = mutants::wrongBounds(*tree, shadows);
        if (!mutant && shadows < 10000) return {"hardly any sample is in a shadow"};
        return {wrong, fmt::format("{}{} shadows, none lost", costs, shadows)};
    });
}
