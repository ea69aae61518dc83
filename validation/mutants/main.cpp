// SPDX-License-Identifier: MIT
// gnomon-mutants [NAME...]: every mutant that this program is linked with (or those named) has to fail a case that the modules as they stand pass.
// Prints a table: mutant, killed by. Exit code 0: all as it should be; 1: a mutant survives or the modules themselves fail; then it says which.
#include <algorithm>
#include <cstdio>
#include <ctime>

#include "validation/mutants/cases.hpp"

namespace {

bool isMutant(const std::string& name) { return name.find('.') != std::string::npos; }

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

int main(int argc, char** argv) {
    const std::vector<gno::mutants::Case> cases = gno::mutants::makeCases();
    const std::vector<std::string> wanted(argv + 1, argv + argc);
    auto variants = gno::cpu::topVariants();
    std::sort(variants.begin(), variants.end(),
              [](const auto& x, const auto& y) { return std::pair(isMutant(x.name), x.name) < std::pair(isMutant(y.name), y.name); });
    int mutants = 0, survivors = 0, broken = 0;
    for (const auto& variant : variants) {
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), variant.name) == wanted.end()) continue;
        const auto tree = variant.make();
        const std::clock_t start = std::clock();
        std::string killer;
        for (const size_t part : {size_t{20}, size_t{1}}) {  // most mutants die of the first few scenes of a case
            if (part > 1 && !isMutant(variant.name)) continue;
            for (const auto& c : cases) {
                const std::string failure = gno::mutants::failure(c, *tree, c.scenes.size() / part);
                if (failure.empty()) continue;
                if (isMutant(variant.name)) {
                    killer = c.name + " (" + firstLine(failure) + ")";
                    break;
                }
                std::printf("%s fails '%s': %s\n", variant.name.c_str(), c.name.c_str(), failure.c_str());
                ++broken;
            }
            if (!killer.empty()) break;
        }
        const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
        if (!isMutant(variant.name)) {
            std::printf("%-60s the modules as they stand, all %zu cases, %.1f s\n", variant.name.c_str(), cases.size(), seconds);
        } else {
            ++mutants;
            survivors += killer.empty();
            std::printf("%-60s %s %s, %.1f s\n", variant.name.c_str(), killer.empty() ? "SURVIVES" : "killed by:", killer.c_str(), seconds);
        }
        std::fflush(stdout);
    }
    std::printf("%d mutants, %d survive; %d failures of the modules as they stand\n", mutants, survivors, broken);
    return survivors == 0 && broken == 0 && (mutants > 0 || !wanted.empty()) ? 0 : 1;
}
