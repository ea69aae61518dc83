// SPDX-License-Identifier: MIT
// gnomon-forest-mutants [NAME...]: the forest's text on the CPU. As it stands it has to hold all claims of forest_cases.hpp; every mutant that this
// program is linked with (or those named) has to break one. Prints a table: mutant, killed by. Exit code 0: all as it should be; 1: not; then it
// says which.
#include <algorithm>
#include <cstdio>
#include <ctime>

#include "validation/mutants/forest_cases.hpp"

namespace gno::mutants {
namespace {

constexpr uint kQuestions = 3000;
constexpr size_t kScenes = 24;

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Empty when no check fails.
std::string killer(cpu::Forest& forest, const std::vector<CellFamily>& families, const std::vector<ForestCase>& cases) {
    for (const size_t part : {size_t{8}, size_t{1}}) {  // most mutants die of the first few
        cpu::CellTally tally;
        for (const CellFamily& family : families) {
            const std::string wrong = failure(family, forest, tally, family.questions.size() / part);
            if (!wrong.empty()) return firstLine(wrong);
        }
        for (const ForestCase& c : cases) {
            const std::string wrong = failure(c, forest, c.scenes.size() / part);
            if (!wrong.empty()) return firstLine(wrong);
        }
    }
    return {};
}

int run(const std::vector<std::string>& wanted) {
    const std::vector<CellFamily> families = makeCellFamilies(kQuestions);
    const std::vector<ForestCase> cases = makeForestCases(kScenes);
    auto variants = cpu::forestVariants();
    std::sort(variants.begin(), variants.end(), [](const auto& x, const auto& y) { return x.name < y.name; });
    int mutants = 0, survivors = 0, broken = 0;
    for (const auto& variant : variants) {
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), variant.name) == wanted.end()) continue;
        const auto forest = variant.make();
        const std::clock_t start = std::clock();
        const std::string by = killer(*forest, families, cases);
        const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
        if (variant.name == "plain") {
            broken += !by.empty();
            std::printf("%-50s the modules as they stand: %s, %.1f s\n", variant.name.c_str(), by.empty() ? "nothing wrong" : by.c_str(), seconds);
        } else {
            ++mutants;
            survivors += by.empty();
            std::printf("%-50s %s %s, %.1f s\n", variant.name.c_str(), by.empty() ? "SURVIVES" : "killed by:", by.c_str(), seconds);
        }
        std::fflush(stdout);
    }
    std::printf("%d mutants, %d survive; %d failures of the modules as they stand\n", mutants, survivors, broken);
    return survivors == 0 && broken == 0 && (mutants > 0 || !wanted.empty()) ? 0 : 1;
}

}  // namespace
}  // namespace gno::mutants

int main(int argc, char** argv) { return gno::mutants::run({argv + 1, argv + argc}); }
