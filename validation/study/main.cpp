// SPDX-License-Identifier: MIT
// gnomon-study: what accuracy costs in time. One subcommand a header. Exit codes: 0 done, 2 bad input or device, 1 anything else, always with one
// line.
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "host_min/error.hpp"
#include "host_min/interrupt.hpp"
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
    addShort(program, chosen);
    addFull(program, chosen);
    addPlan(program, chosen, argv[0]);
    addMerge(program, chosen);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return program.exit(error);  // help
        throw gno::host::InputError(std::string(error.what()) + " (see gnomon-study --help)");
    }
    const int code = chosen();
    if (std::fflush(stdout) != 0) throw gno::host::WorkError("cannot write to standard output: is the disk full, or the reader gone?");
    return code;
}

int fail(const std::string& text, int code) {
    std::string line = text;
    for (char& c : line)
        if (c == '\n' || c == '\r') c = ' ';
    std::fprintf(stderr, "gnomon-study: %s\n", line.c_str());
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    gno::host::catchInterrupts();
    try {
        return run(argc, argv);
    } catch (const gno::host::InputError& error) {
        return fail(error.what(), 2);
    } catch (const std::bad_alloc&) {
        return fail("out of memory: use a smaller --size or scene", 1);
    } catch (const std::exception& error) {
        return fail(error.what(), 1);
    }
}
