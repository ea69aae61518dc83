// SPDX-License-Identifier: MIT
// gnomon-hard-cases: runs the hard cases and prints what every technique made of them as Markdown. Wrong answers are a result, not an error.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "host_min/error.hpp"
#include "host_min/interrupt.hpp"
#include "host_min/output/atomic_file.hpp"
#include "host_min/output/guarded.hpp"
#include "host_min/output/table.hpp"
#include "validation/hard_cases/report.hpp"

namespace {

using namespace gno;

int run(int argc, char** argv) {
    CLI::App app{"Hard cases through every technique, as a Markdown table", "gnomon-hard-cases"};
    std::string wanted, update;
    bool list = false;
    hard::RunnerOptions options{.insertionSeeds = 8, .counters = true};
    app.add_option("--case", wanted, "only cases whose name contains this");
    app.add_option("--seeds", options.insertionSeeds, "insertion seeds per case")->check(CLI::Range(1, 1000))->capture_default_str();
    app.add_option("--update", update, "write into this Markdown file, between its hard-cases markers");
    app.add_flag("--uncertified", options.uncertified,
                 "techniques that have no certified rung as well (a shadow map draws: not at subgroup width 16)");
    app.add_flag("--list", list, "name the cases, run nothing");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);
        throw host::InputError(error.what());
    }

    std::string before;
    if (!update.empty()) {  // checked before the work
        std::ifstream file(update);
        if (!file) throw host::InputError("cannot read " + update);
        before = (std::ostringstream() << file.rdbuf()).str();
        (void)hard::replaceSection(before, "");
    }
    std::vector<const hard::HardCase*> chosen;
    for (const hard::HardCase& hardCase : hard::hardCases())
        if (hardCase.name.find(wanted) != std::string::npos) chosen.push_back(&hardCase);
    if (chosen.empty()) throw host::InputError("no hard case has \"" + wanted + "\" in its name; --list names them");
    if (list) {
        for (const hard::HardCase* hardCase : chosen) std::printf("%s: %s\n", hardCase->name.c_str(), hardCase->why.c_str());
        return 0;
    }

    std::vector<hard::CaseResult> results;
    host::Progress progress;
    for (const hard::HardCase* hardCase : chosen) {
        results.push_back(hard::runCase(*hardCase, options, [&] {
            host::throwIfInterrupted();
            progress.show(hardCase->name, double(results.size()) / double(chosen.size()));
        }));
        if (!results.back().oracleWrong.empty()) throw host::WorkError("the oracle differs from brute force: " + results.back().oracleWrong);
        for (const hard::Tally& tally : results.back().tallies) {
            if (tally.precision != host::Precision::certified || tally.wrong == 0) continue;
            progress.clear();
            std::fprintf(stderr, "certified, and wrong: %s\n", tally.firstWrong.c_str());
        }
    }
    progress.clear();
    const std::string text = hard::markdown(results, options);
    if (update.empty()) {
        std::printf("%s", text.c_str());
    } else {
        host::AtomicFile file(update);
        file.stream() << hard::replaceSection(before, text);
        file.commit();
    }
    if (test::passes().device().validationMessages() > 0) throw host::WorkError("the validation layer had something to say (see above)");
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    gno::host::catchInterrupts("gnomon-hard-cases", gno::host::removeUnfinishedFiles);
    return gno::host::guarded("gnomon-hard-cases", "use fewer --seeds", [&] { return run(argc, argv); });
}
