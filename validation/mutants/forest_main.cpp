// SPDX-License-Identifier: MIT
// gnomon-forest-mutants [NAME...]: the forest's text on the CPU: the claims of forest_cases.hpp. What is printed: run.hpp.
#include "validation/mutants/forest_cases.hpp"
#include "validation/mutants/run.hpp"

int main(int argc, char** argv) {
    using namespace gno;
    const std::vector<mutants::CellFamily> families = mutants::makeCellFamilies(3000);
    const std::vector<mutants::ForestCase> cases = mutants::makeForestCases(24);
    return mutants::run({argv + 1, argv + argc}, cpu::forestVariants(), [&](const auto& variant, bool mutant) -> mutants::Verdict {
        const auto forest = variant.make();
        for (const size_t part : {size_t{8}, size_t{1}}) {  // most mutants die of the first few
            if (part > 1 && !mutant) continue;
            cpu::CellTally tally;
            for (const mutants::CellFamily& family : families) {
                const std::string wrong = mutants::failure(family, *forest, tally, family.questions.size() / part);
                if (!wrong.empty()) return {wrong};
            }
            for (const mutants::ForestCase& c : cases) {
                const std::string wrong = mutants::failure(c, *forest, c.scenes.size() / part);
                if (!wrong.empty()) return {wrong};
            }
        }
        return {};
    });
}
