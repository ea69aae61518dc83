// SPDX-License-Identifier: MIT
// gnomon-study: what accuracy costs in time. One subcommand a header. Exit codes: 0 done, 2 bad input or device, 1 anything else, always with one
// line.
#include "host_min/error.hpp"
#include "host_min/interrupt.hpp"
#include "host_min/output/atomic_file.hpp"
#include "host_min/output/guarded.hpp"
#include "validation/study/merge.hpp"
#include "validation/study/plan.hpp"
#include "validation/study/presets.hpp"
#include "validation/study/report/command.hpp"
#include "validation/study/sweep.hpp"

namespace {

int run(int argc, char** argv) {
    using namespace gno::study;
    CLI::App program("gnomon-study: what accuracy costs in time");
    program.require_subcommand(1);
    Action chosen;
    addSweep(program, chosen);
    addReport(program, chosen);
    addShort(program, chosen, finishStudy);
    addFull(program, chosen, finishStudy);
    addPlan(program, chosen, argv[0]);
    addMerge(program, chosen);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return program.exit(error);  // help
        throw gno::host::InputError(std::string(error.what()) + " (see gnomon-study --help)");
    }
    return chosen();
}

}  // namespace

int main(int argc, char** argv) {
    gno::host::catchInterrupts("gnomon-study", gno::host::removeUnfinishedFiles);
    return gno::host::guarded("gnomon-study", "use a smaller --size or scene", [&] { return run(argc, argv); });
}
