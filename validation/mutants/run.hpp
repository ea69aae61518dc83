// SPDX-License-Identifier: MIT
// What the programs of mutants share: each variant of a text that a program is linked with is judged; one whose name has a dot in it is a mutant.
#pragma once
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

namespace gno::mutants {

struct Verdict {
    std::string failure;  ///< empty: all checks pass. Else line one says which does not; more lines may follow
    std::string note{};   ///< what was seen of a text as it stands
};

inline bool isMutant(const std::string& name) { return name.find('.') != std::string::npos; }

/// Judges all variants, or those named. The text as it stands has to pass, every mutant has to fail. Prints a table: mutant, killed by. The exit
/// code: 0 when all is as it should be; else 1, and the table says what is not.
/// judge(variant, mutant): its checks; an exception is a failure, too. For a text as it stands a check that tested nothing is a failure.
template <class Variant, class Judge>
int run(const std::vector<std::string>& wanted, std::vector<Variant> variants, const Judge& judge) {
    std::sort(variants.begin(), variants.end(),
              [](const Variant& x, const Variant& y) { return std::pair(isMutant(x.name), x.name) < std::pair(isMutant(y.name), y.name); });
    int plain = 0, mutants = 0, survivors = 0, broken = 0;
    for (const Variant& variant : variants) {
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), variant.name) == wanted.end()) continue;
        const bool mutant = isMutant(variant.name);
        const std::clock_t start = std::clock();
        Verdict verdict;
        try {
            verdict = judge(variant, mutant);
        } catch (const std::exception& error) {
            verdict.failure = error.what();
        }
        const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
        ++(mutant ? mutants : plain);
        survivors += mutant && verdict.failure.empty();
        broken += !mutant && !verdict.failure.empty();
        if (mutant) {
            const std::string by = verdict.failure.substr(0, verdict.failure.find('\n'));
            std::printf("%-58s %s %s, %.1f s\n", variant.name.c_str(), by.empty() ? "SURVIVES" : "killed by:", by.c_str(), seconds);
        } else {
            std::printf("%-58s the text as it stands %s%s, %.1f s\n", variant.name.c_str(), verdict.failure.empty() ? "passes" : "FAILS: ",
                        verdict.failure.empty() ? (verdict.note.empty() ? "" : ": " + verdict.note).c_str() : verdict.failure.c_str(), seconds);
        }
        std::fflush(stdout);
    }
    std::printf("%d mutants, %d survive; %d texts as they stand, %d fail\n", mutants, survivors, plain, broken);
    const bool all = wanted.empty() ? mutants > 0 && plain > 0 : size_t(mutants + plain) == wanted.size();
    if (!all) std::printf("%s\n", wanted.empty() ? "this program is linked with too little" : "not every name that was given is one");
    return all && survivors == 0 && broken == 0 ? 0 : 1;
}

}  // namespace gno::mutants
