// SPDX-License-Identifier: MIT
// gnomon-top-mutants [NAME...]: the TOP tree's text, and what of core/ it is made of, on the CPU: the cases of cases.hpp. What is printed: run.hpp.
#include "validation/mutants/cases.hpp"
#include "validation/mutants/run.hpp"

int main(int argc, char** argv) {
    using namespace gno;
    const std::vector<mutants::Case> cases = mutants::makeCases();
    return mutants::run({argv + 1, argv + argc}, cpu::topVariants(), [&](const cpu::TopVariant& variant, bool mutant) -> mutants::Verdict {
        const auto tree = variant.make();
        for (const size_t part : {size_t{20}, size_t{1}}) {  // most mutants die of the first few scenes of a case
            if (part > 1 && !mutant) continue;
            for (const mutants::Case& c : cases) {
                const std::string failure = mutants::failure(c, *tree, c.scenes.size() / part);
                if (!failure.empty()) return {c.name + ", " + failure};
            }
        }
        return {"", "all " + std::to_string(cases.size()) + " cases"};
    });
}
